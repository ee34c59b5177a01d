// SPDX-License-Identifier: Apache-2.0
// The sum over light samples starts at 0.
void main() { out_visibility = 0.0; }
