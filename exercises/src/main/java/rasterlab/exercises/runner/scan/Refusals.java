package rasterlab.exercises.runner.scan;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.Message;

/**
 * What is not allowed in a student's classes: one message for each mistake, with the line in the
 * source.
 *
 * <p>A class is told once, where it is used first. Of a line all is told that stands in it, but for
 * what comes of the same mistake: calls of what a refused one answers. So do the exceptions that
 * they declare, which are told only where nothing else is.
 */
final class Refusals {
    private static final int MOST = 20;

    private final List<String> sourceLines;

    /**
     * @param word that stands in the source, as a rule
     */
    private record Found(Diagnostic diagnostic, String word) {
        int line() {
            return diagnostic.line();
        }
    }

    /** In the order of instructions; classes by their internal names, others by what is said. */
    private final Map<String, Found> found = new LinkedHashMap<>();

    private final Map<String, Found> exceptions = new LinkedHashMap<>();

    /** By lines, the classes of what refused calls in them answer. */
    private final Map<Integer, Set<String>> answers = new HashMap<>();

    Refusals(String source) {
        this.sourceLines = source.lines().toList();
    }

    /**
     * @param line from the line table; 0 where the class file has none, then the first line of the
     *     source that mentions the class is named, if no instruction uses it
     * @param type internal name of a class
     */
    void addClass(int line, String type) {
        Map<String, Found> same = type.endsWith("Exception") ? exceptions : found;
        Found before = same.get(type);
        boolean better = before != null && before.line() == 0 && line > 0;
        if (!better && (before != null || same.size() >= MOST)) return;
        String name = readable(type);
        same.put(
                type,
                new Found(
                        new Diagnostic(line, 0, Message.of("not-allowed.class", name)),
                        lastWord(name)));
    }

    /**
     * What a refused call answers: calls of that in the same line are no mistakes of their own.
     *
     * @param type internal name of a class
     */
    void addAnswer(int line, String type) {
        answers.computeIfAbsent(line, one -> new HashSet<>()).add(type);
    }

    /** Whether a refused call in that line answers such an object. */
    boolean isAnswer(int line, String type) {
        return line > 0 && answers.getOrDefault(line, Set.of()).contains(type);
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
                key ->
                        new Found(
                                new Diagnostic(line > 0 ? line : mention(word), 0, said),
                                lastWord(word)));
    }

    private static String lastWord(String name) {
        return name.substring(name.lastIndexOf('.') + 1);
    }

    private static String readable(String thing) {
        return thing.replace('/', '.').replace('$', '.');
    }

    /** Whether more would not be told. */
    boolean isFull() {
        return found.size() >= MOST;
    }

    private int mention(String thing) {
        String word = lastWord(thing);
        for (int line = 1; line <= sourceLines.size(); line++) if (stands(word, line)) return line;
        return 0;
    }

    private boolean stands(String word, int line) {
        if (line > sourceLines.size()) return false;
        Pattern pattern = Pattern.compile("\\b" + Pattern.quote(word) + "\\b");
        return pattern.matcher(sourceLines.get(line - 1)).find();
    }

    /** In the order of their lines; of a line at least the first, and all that stands in it. */
    List<Diagnostic> list() {
        Map<Integer, List<Found>> lines = new TreeMap<>();
        (found.isEmpty() ? exceptions : found)
                .values().stream()
                        .map(this::placed)
                        .forEach(
                                one ->
                                        lines.computeIfAbsent(one.line(), is -> new ArrayList<>())
                                                .add(one));
        return lines.values().stream().flatMap(this::toBeTold).map(Found::diagnostic).toList();
    }

    private Stream<Found> toBeTold(List<Found> inOneLine) {
        if (inOneLine.get(0).line() == 0) return inOneLine.stream();
        List<Found> standing =
                inOneLine.stream().filter(one -> stands(one.word(), one.line())).toList();
        return standing.isEmpty() ? inOneLine.stream().limit(1) : standing.stream();
    }

    private Found placed(Found one) {
        if (one.line() > 0) return one;
        return new Found(
                new Diagnostic(mention(one.word()), 0, one.diagnostic().said()), one.word());
    }
}
