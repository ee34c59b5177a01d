// SPDX-License-Identifier: Apache-2.0
// Where the stencil lets it.
void main() { out_visibility = 1.0; }
