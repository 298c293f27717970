package rasterlab.app.opengl.context;

/** There is no OpenGL here; the message says what is missing. */
public final class NoOpenGl extends RuntimeException {
    private static final long serialVersionUID = 1L;

    public NoOpenGl(String missing) {
        super(missing);
    }

    /** For what a library says or throws when it cannot make a context. */
    public NoOpenGl(Throwable cause) {
        super(said(cause), cause);
    }

    private static String said(Throwable failure) {
        Throwable deepest = failure;
        while (deepest.getCause() != null) deepest = deepest.getCause();
        String message = deepest.getMessage();
        return message == null || message.isBlank()
                ? deepest.getClass().getSimpleName()
                : message.lines().findFirst().orElse(message);
    }
}
