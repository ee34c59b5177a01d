// SPDX-License-Identifier: Apache-2.0
// Whatever is projected here keeps the light away.
void main() { out_lit = 0.0; }
