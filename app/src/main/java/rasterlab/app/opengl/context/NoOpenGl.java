package rasterlab.app.opengl.context;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** There is no OpenGL here; the message says what is missing. */
public final class NoOpenGl extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /** The failure in LWJGL's words, which Java repeats among others when it is asked again. */
    private static final Pattern LIBRARY =
            Pattern.compile("Failed to locate library: ([^\\s\\[]+)");

    public NoOpenGl(String missing) {
        super(missing);
    }

    /** An error for what a library says or throws when it cannot make a context. */
    public NoOpenGl(Throwable cause) {
        super(reason(cause), cause);
    }

    private static String reason(Throwable failure) {
        Throwable deepest = failure;
        while (deepest.getCause() != null) deepest = deepest.getCause();
        String message = deepest.getMessage();
        Matcher library = LIBRARY.matcher(String.valueOf(message));
        if (library.find()) return "library " + library.group(1) + " is missing";
        return message == null || message.isBlank()
                ? deepest.getClass().getSimpleName()
                : message.lines().findFirst().orElse(message);
    }
}
