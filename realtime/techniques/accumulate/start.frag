// SPDX-License-Identifier: Apache-2.0
// The sum starts at nothing.
void main() { out_visibility = 0.0; }
