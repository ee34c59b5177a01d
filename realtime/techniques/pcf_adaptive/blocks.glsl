const int kBlockTexels = 16;  // const: as in the size of `blocks` in technique.toml
