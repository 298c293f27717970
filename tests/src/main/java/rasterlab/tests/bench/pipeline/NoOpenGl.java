package rasterlab.tests.bench.pipeline;

/** There is no OpenGL here; the message says what is missing. */
final class NoOpenGl extends RuntimeException {
    private static final long serialVersionUID = 1;

    NoOpenGl(String missing) {
        super(missing);
    }
}
