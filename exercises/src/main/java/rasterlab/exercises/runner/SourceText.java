package rasterlab.exercises.runner;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import rasterlab.exercises.Grading;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;

/** Looks at a source before any process is started. */
final class SourceText {
    /** Deeper nesting than any person writes; the compiler recurses over it. */
    private static final int DEEPEST = 200;

    private SourceText() {}

    /** Why a source is not even compiled. */
    record SourceFault(GradingVerdict verdict, Diagnostic diagnostic) {}

    /**
     * The source without the byte order mark that some editors put in front, such as Windows
     * Notepad.
     */
    static String withoutMark(String source) {
        return source.startsWith("\uFEFF") ? source.substring(1) : source;
    }

    static Optional<SourceFault> faultOf(String source) {
        if (source.length() > Grading.MOST_SOURCE_BYTES
                || source.getBytes(StandardCharsets.UTF_8).length > Grading.MOST_SOURCE_BYTES)
            return Optional.of(
                    new SourceFault(
                            GradingVerdict.REFUSED,
                            new Diagnostic(
                                    0, 0, Message.of("source.long", Grading.MOST_SOURCE_BYTES))));
        if (source.isBlank()) return fault(source, 0, Message.of("source.empty"));
        for (int i = 0; i < source.length(); i++) {
            Message wrong = wrong(source, i);
            if (!wrong.isEmpty()) return fault(source, i, wrong);
        }
        return tooDeep(source);
    }

    private static Message wrong(String source, int i) {
        char c = source.charAt(i);
        if (c == '\uFEFF') return Message.of("source.mark");
        if (c == 0) return Message.of("source.nul");
        if (c >= '\u202A' && c <= '\u202E' || c >= '\u2066' && c <= '\u2069')
            return Message.of("source.direction", codePoint(c));
        boolean lone =
                Character.isHighSurrogate(c)
                        ? i + 1 == source.length()
                                || !Character.isLowSurrogate(source.charAt(i + 1))
                        : Character.isLowSurrogate(c)
                                && (i == 0 || !Character.isHighSurrogate(source.charAt(i - 1)));
        return lone ? Message.of("source.half", codePoint(c)) : Message.NONE;
    }

    private static String codePoint(char c) {
        return String.format("U+%04X", (int) c);
    }

    /** Counts brackets wherever they stand; text and comments with 200 open ones are unlikely. */
    private static Optional<SourceFault> tooDeep(String source) {
        int depth = 0;
        for (int i = 0; i < source.length(); i++) {
            char c = source.charAt(i);
            if (c == '(' || c == '{' || c == '[') depth++;
            if ((c == ')' || c == '}' || c == ']') && depth > 0) depth--;
            if (depth > DEEPEST) return fault(source, i, Message.of("complex.brackets", DEEPEST));
        }
        return Optional.empty();
    }

    private static Optional<SourceFault> fault(String source, int at, Message said) {
        int line = 1;
        int lineStart = 0;
        for (int i = 0; i < at; i++) {
            char c = source.charAt(i);
            if (c == '\n' || c == '\r' && source.charAt(i + 1) != '\n') {
                line++;
                lineStart = i + 1;
            }
        }
        return Optional.of(
                new SourceFault(
                        GradingVerdict.COMPILE_ERROR,
                        new Diagnostic(line, at - lineStart + 1, said)));
    }
}
