package rasterlab.exercises.runner;

import java.io.DataInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import rasterlab.exercises.child.Frames;
import rasterlab.exercises.child.Wire;
import rasterlab.exercises.runner.process.Child;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.runner.process.Request;
import rasterlab.exercises.runner.process.TimeLimit;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;

/**
 * The answer of the compiling child to a source.
 *
 * @param verdict OK where there are classes
 * @param classes binary name to class file; empty where there are errors
 * @param errors compiler messages, or why the classes are refused; empty where there are classes
 */
record Compilation(GradingVerdict verdict, Map<String, byte[]> classes, List<Diagnostic> errors) {
    private static final int MOST_ERRORS = 20;
    private static final Pattern CLASS = Pattern.compile("\\b(?:class|record|enum|interface)\\b");

    /**
     * @throws ChildLost when the child ended by a fault that is not the source's
     */
    static Compilation of(String source, Child child, TimeLimit limit)
            throws ChildLost, InterruptedException {
        byte[] bytes = source.getBytes(StandardCharsets.UTF_8);
        Request request = new Request(Wire.COMPILE, out -> Frames.write(out, bytes));
        try {
            return child.ask(request, limit, (status, in) -> of(source, status, in));
        } catch (ChildLost lost) {
            if (lost.isIdle()) throw lost;
            return switch (lost.reason()) {
                case TIME -> tooComplex("complex.time", Child.seconds(limit.processor()));
                case MEMORY -> tooComplex("complex.memory");
                default -> throw lost;
            };
        }
    }

    /**
     * The answer of a compiler to the source.
     *
     * @param status of {@link Wire}
     * @param in the rest of its answer
     */
    static Compilation of(String source, int status, DataInputStream in) throws IOException {
        Compilation answer = read(status, in);
        if (answer.verdict() != GradingVerdict.COMPILE_ERROR) return answer;
        return KotlinSource.in(source)
                .or(() -> withoutClass(source))
                .map(one -> failed(answer.verdict(), List.of(one)))
                .orElse(answer);
    }

    /** The compiler's own words on a text without any class speak of modules. */
    private static Optional<Diagnostic> withoutClass(String source) {
        return CLASS.matcher(source).find()
                ? Optional.empty()
                : Optional.of(diagnostic("source.no-class"));
    }

    private static Compilation read(int status, DataInputStream in) throws IOException {
        return switch (status) {
            case Wire.DONE -> new Compilation(GradingVerdict.OK, classes(in), List.of());
            case Wire.COMPILER_ERRORS -> failed(GradingVerdict.COMPILE_ERROR, errors(in));
            case Wire.TOO_COMPLEX -> tooComplex("complex.gave-up");
            case Wire.TOO_MANY_CLASSES -> refused("classes.many", in.readLong(), Wire.MOST_CLASSES);
            case Wire.CLASSES_TOO_LONG ->
                    refused("classes.long", in.readLong(), Wire.MOST_CLASS_BYTES);
            default -> throw new IOException("status " + status + " after a compilation");
        };
    }

    private static Map<String, byte[]> classes(DataInputStream in) throws IOException {
        Map<String, byte[]> classes = new LinkedHashMap<>();
        for (int left = count(in, Wire.MOST_CLASSES); left > 0; left--)
            classes.put(in.readUTF(), Frames.read(in, Wire.MOST_CLASS_BYTES));
        return classes;
    }

    private static List<Diagnostic> errors(DataInputStream in) throws IOException {
        List<Diagnostic> errors = new ArrayList<>();
        for (int left = count(in, MOST_ERRORS); left > 0; left--)
            errors.add(
                    new Diagnostic(
                            Math.max(0, in.readInt()),
                            Math.max(0, in.readInt()),
                            Message.quoted(Wire.cut(in.readUTF()))));
        return errors;
    }

    private static int count(DataInputStream in, int most) throws IOException {
        int count = in.readInt();
        if (count < 0 || count > most)
            throw new IOException(count + " items, at most " + most + " are allowed");
        return count;
    }

    private static Compilation tooComplex(String key, Object... arguments) {
        return failed(GradingVerdict.COMPILE_ERROR, List.of(diagnostic(key, arguments)));
    }

    private static Compilation refused(String key, long amount, int most) {
        return failed(GradingVerdict.REFUSED, List.of(diagnostic(key, amount, most)));
    }

    private static Diagnostic diagnostic(String key, Object... arguments) {
        return new Diagnostic(0, 0, Message.of(key, arguments));
    }

    private static Compilation failed(GradingVerdict verdict, List<Diagnostic> errors) {
        return new Compilation(verdict, Map.of(), errors);
    }
}
