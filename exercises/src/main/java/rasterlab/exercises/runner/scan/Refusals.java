package rasterlab.exercises.runner.scan;

import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.Message;

/**
 * What is not allowed in a student's classes: one message for each mistake, with the line in the
 * source.
 *
 * <p>A class is told once, where it is used first. What else is wrong in a line that has a message
 * comes of the same mistake as a rule: calls that are chained, or what they answer. So do the
 * exceptions that they declare, which are told only where nothing else is.
 */
final class Refusals {
    private static final int MOST = 20;

    private final List<String> sourceLines;

    /** In the order of instructions; classes by their internal names, others by what is said. */
    private final Map<String, Diagnostic> found = new LinkedHashMap<>();

    private final Map<String, Diagnostic> exceptions = new LinkedHashMap<>();

    Refusals(String source) {
        this.sourceLines = source.lines().toList();
    }

    /**
     * @param line from the line table; 0 where the class file has none, then the first line of the
     *     source that mentions the class is named, if no instruction uses it
     * @param type internal name of a class
     */
    void addClass(int line, String type) {
        Map<String, Diagnostic> same = type.endsWith("Exception") ? exceptions : found;
        Diagnostic before = same.get(type);
        boolean better = before != null && before.line() == 0 && line > 0;
        if (!better && (before != null || same.size() >= MOST)) return;
        same.put(type, new Diagnostic(line, 0, Message.of("not-allowed.class", readable(type))));
    }

    /**
     * A member of a class that may be mentioned.
     *
     * @param name of a method or field, or that of constructors
     * @param some members of the class that may be used; none where most may
     */
    void addMember(int line, String owner, String name, List<String> some) {
        String type = readable(owner);
        Message refused =
                name.equals("<init>")
                        ? Message.of("not-allowed.constructor", type)
                        : Message.of("not-allowed", type + "." + name);
        Message instead =
                some.isEmpty()
                        ? Message.NONE
                        : Message.of("allowed.members", type, String.join(", ", some));
        add(line, name.equals("<init>") ? type : name, refused.and(instead));
    }

    /** Something that has no name in the source, or only the one it is told by. */
    void add(int line, String thing) {
        add(line, thing, Message.of("not-allowed", readable(thing)));
    }

    private void add(int line, String word, Message said) {
        if (isFull()) return;
        found.computeIfAbsent(
                line + ": " + said,
                key -> new Diagnostic(line > 0 ? line : mention(word), 0, said));
    }

    private static String readable(String thing) {
        return thing.replace('/', '.').replace('$', '.');
    }

    /** Whether more would not be told. */
    boolean isFull() {
        return found.size() >= MOST;
    }

    private int mention(String thing) {
        String word = thing.substring(thing.lastIndexOf('.') + 1);
        Pattern pattern = Pattern.compile("\\b" + Pattern.quote(word) + "\\b");
        for (int i = 0; i < sourceLines.size(); i++)
            if (pattern.matcher(sourceLines.get(i)).find()) return i + 1;
        return 0;
    }

    /** In the order of their lines, one for each line. */
    List<Diagnostic> list() {
        Set<Integer> told = new HashSet<>();
        return (found.isEmpty() ? exceptions : found)
                .entrySet().stream()
                        .map(this::placed)
                        .sorted(Comparator.comparingInt(Diagnostic::line))
                        .filter(one -> one.line() == 0 || told.add(one.line()))
                        .toList();
    }

    private Diagnostic placed(Map.Entry<String, Diagnostic> one) {
        if (one.getValue().line() > 0) return one.getValue();
        return new Diagnostic(mention(readable(one.getKey())), 0, one.getValue().said());
    }
}
