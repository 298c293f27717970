package rasterlab.engine.transform;

/** Which of OpenGL's matrices is meant; each has a stack of its own. */
public enum MatrixMode {
    MODELVIEW(32),
    PROJECTION(2),
    TEXTURE(2);

    private final int depth;

    MatrixMode(int depth) {
        this.depth = depth;
    }

    /** The most matrices on the stack, the least that OpenGL guarantees. */
    public int depth() {
        return depth;
    }
}
