package rasterlab.exercises.runner.scan;

import static java.util.stream.Collectors.groupingBy;
import static java.util.stream.Collectors.toList;
import static java.util.stream.Collectors.toSet;

import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.Stream;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.Message;

/**
 * The things in a student's classes that are not allowed: one message for each mistake, with the
 * line in the source.
 *
 * <p>A class is told once, where it is used first. Of a line all is told that stands in it, but for
 * what comes of the same mistake: calls of what a refused one answers. So do the exceptions that
 * they declare, which are told only where nothing else is.
 */
final class SourceRefusals {
    private static final int MOST = 20;

    private final String source;

    /**
     * @param word that stands in the source, as a rule
     * @param allowed what may be used instead, said once for all that it is said of
     */
    private record Found(int line, Message message, String word, Message allowed) {
        Found at(int otherLine) {
            return new Found(otherLine, message, word, allowed);
        }

        Diagnostic diagnostic(boolean last) {
            return new Diagnostic(line, 0, last ? message.and(allowed) : message);
        }
    }

    /**
     * One mistake, however often the instructions of its line repeat it.
     *
     * @param owner empty where the name is no member's
     */
    private record Mistake(int line, String owner, String name) {}

    /**
     * The findings, in the order of instructions; classes by their internal names, others by their
     * mistakes.
     */
    private final Map<Object, Found> found = new LinkedHashMap<>();

    private final Map<Object, Found> exceptions = new LinkedHashMap<>();

    /** The classes of what refused calls answer, by lines. */
    private final Map<Integer, Set<String>> answers = new HashMap<>();

    SourceRefusals(String source) {
        this.source = source;
    }

    /**
     * @param line from the line table; 0 where the class file has none, then the first line of the
     *     source that mentions the class is named, if no instruction uses it
     * @param type internal name of a class
     */
    void addClass(int line, String type) {
        Map<Object, Found> same = type.endsWith("Exception") ? exceptions : found;
        Found before = same.get(type);
        boolean better = before != null && before.line() == 0 && line > 0;
        if (!better && (before != null || same.size() >= MOST)) return;
        String name = readable(type);
        same.put(
                type,
                new Found(
                        line,
                        Message.of("not-allowed.class", name),
                        lastWord(name),
                        Message.of("allowed.classes")));
    }

    /**
     * Adds the type that a refused call answers: calls of it in the same line are no mistakes of
     * their own.
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
     * Adds a member of a class that may be mentioned.
     *
     * @param name of a method or field, or that of constructors
     * @param some members of the class that may be used; none where most may
     */
    void addMember(int line, String owner, String name, Supplier<List<String>> some) {
        if (isFull()) return;
        found.computeIfAbsent(
                new Mistake(line, owner, name), key -> member(line, owner, name, some.get()));
    }

    private static Found member(int line, String owner, String name, List<String> some) {
        String type = readable(owner);
        Message refused =
                name.equals("<init>")
                        ? Message.of("not-allowed.constructor", type)
                        : Message.of("not-allowed", type + "." + name);
        Message instead =
                some.isEmpty()
                        ? Message.NONE
                        : Message.of("allowed.members", type, String.join(", ", some));
        return new Found(line, refused, lastWord(name.equals("<init>") ? type : name), instead);
    }

    /** Adds something that has no name in the source, or only the one it is told by. */
    void add(int line, String thing) {
        if (isFull()) return;
        found.computeIfAbsent(
                new Mistake(line, "", thing),
                key ->
                        new Found(
                                line,
                                Message.of("not-allowed", readable(thing)),
                                lastWord(thing),
                                Message.NONE));
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

    /**
     * The diagnostics in the order of their places in the source; of a line at least the first, and
     * all that stands in it. What may be used instead is said with the last that it is said of.
     */
    List<Diagnostic> list() {
        var all = (found.isEmpty() ? exceptions : found).values();
        if (all.isEmpty()) return List.of();
        WordPlaces places =
                WordPlaces.in(
                        source,
                        all.stream().map(Found::word).collect(toSet()),
                        all.stream().map(Found::line).collect(toSet()));
        Map<Integer, List<Found>> lines =
                all.stream()
                        .map(one -> one.line() > 0 ? one : one.at(places.firstLine(one.word())))
                        .collect(groupingBy(Found::line, TreeMap::new, toList()));
        List<Found> told =
                lines.values().stream().flatMap(inOneLine -> toBeTold(inOneLine, places)).toList();
        Map<Message, Found> last = new HashMap<>();
        told.forEach(one -> last.put(one.allowed(), one));
        return told.stream().map(one -> one.diagnostic(last.get(one.allowed()) == one)).toList();
    }

    private static Stream<Found> toBeTold(List<Found> inOneLine, WordPlaces places) {
        int line = inOneLine.get(0).line();
        if (line == 0) return inOneLine.stream();
        List<Found> standing =
                inOneLine.stream()
                        .filter(one -> places.column(one.word(), line) > 0)
                        .sorted(Comparator.comparing(one -> places.column(one.word(), line)))
                        .toList();
        return standing.isEmpty() ? inOneLine.stream().limit(1) : standing.stream();
    }
}
