// Whatever is projected here keeps the light away.
void main() { out_lit = 0.0; }
