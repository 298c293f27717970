package rasterlab.exercises.child;

import java.util.Objects;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The exception that the student's code threw. Of a static initialiser it is what was thrown there
 * first: neither the error around that, nor those at later uses of the class, tell what it was or
 * where.
 *
 * @param error whose trace leads to the place
 * @param type name of the class that was thrown; in an initialiser behind that of the error around
 * @param kept the message where it is known without asking the error
 */
record Thrown(Throwable error, String type, Optional<String> kept) {
    /** The text that the virtual machine keeps of an exception in a static initialiser. */
    private static final Pattern IN_INITIALISER =
            Pattern.compile(
                    "Exception (\\S+?)(?:: (.*))? \\[in thread \"[^\"]*\"\\]", Pattern.DOTALL);

    /** Asks only classes of the JDK for what they hold: the student's own may loop. */
    static Thrown of(Throwable error) {
        Class<?> type = error.getClass();
        if (type == ExceptionInInitializerError.class && error.getCause() != null)
            return inInitialiser(
                    error.getCause(), error.getCause().getClass().getName(), Optional.empty());
        if (type == NoClassDefFoundError.class
                && error.getCause() != null
                && error.getCause().getClass() == ExceptionInInitializerError.class)
            return kept(error.getCause()).orElse(asItIs(error));
        return asItIs(error);
    }

    private static Thrown asItIs(Throwable error) {
        return new Thrown(error, error.getClass().getName(), Optional.empty());
    }

    /**
     * An error in an initialiser, told under that error's name too, or a refusal there would pass
     * for one of the method's own.
     */
    private static Thrown inInitialiser(Throwable error, String type, Optional<String> kept) {
        String around = ExceptionInInitializerError.class.getName();
        return new Thrown(error, around + ": " + type, kept);
    }

    /**
     * @param kept what the virtual machine made of the first error, with the trace of that
     */
    private static Optional<Thrown> kept(Throwable kept) {
        return Optional.ofNullable(kept.getMessage())
                .map(IN_INITIALISER::matcher)
                .filter(Matcher::matches)
                .map(
                        first ->
                                inInitialiser(
                                        kept,
                                        first.group(1),
                                        Optional.of(Objects.toString(first.group(2), ""))));
    }

    /** "" where there is none. */
    String message() {
        try {
            return kept.or(() -> Optional.ofNullable(error.getMessage())).orElse("");
        } catch (Throwable e) {
            return "(its getMessage() threw " + Wire.cut(e.getClass().getName()) + ")";
        }
    }

    /** The innermost line of the student's own; 0 where the trace has none. */
    int line() {
        try {
            for (StackTraceElement call : error.getStackTrace())
                if (Wire.SOURCE_FILE.equals(call.getFileName()))
                    return Math.max(0, call.getLineNumber());
            return 0;
        } catch (Throwable e) {
            return 0;
        }
    }
}
