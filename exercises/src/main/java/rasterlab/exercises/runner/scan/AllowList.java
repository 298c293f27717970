package rasterlab.exercises.runner.scan;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The classes and members that a student's method may use: those that {@code allowed-classes.txt}
 * lists for every exercise, and all of its own contract.
 */
public final class AllowList {
    private static final String FILE = "allowed-classes.txt";

    /** Internal class name to the words after it. */
    private final Map<String, Set<String>> members = new HashMap<>();

    private AllowList(String text, Set<Class<?>> contract) {
        text.lines()
                .map(String::strip)
                .filter(line -> !line.isEmpty() && !line.startsWith("#"))
                .forEach(this::add);
        contract.forEach(this::add);
    }

    /** Adds the type's own members, and of those it inherits the ones that the list allows. */
    private void add(Class<?> type) {
        Set<String> words = new HashSet<>(Set.of("<init>"));
        for (Method method : type.getDeclaredMethods())
            if (Modifier.isPublic(method.getModifiers())) words.add(method.getName());
        for (Field field : type.getFields()) words.add(field.getName());
        if (type.getSuperclass() != null)
            words.addAll(members.getOrDefault(internal(type.getSuperclass().getName()), Set.of()));
        members.put(internal(type.getName()), Set.copyOf(words));
    }

    private static String internal(String name) {
        return name.replace('.', '/');
    }

    private void add(String line) {
        List<String> words = List.of(line.split("\\s+"));
        String name = internal(words.get(0));
        if (members.put(name, Set.copyOf(words.subList(1, words.size()))) != null)
            throw new IllegalStateException(FILE + " lists " + words.get(0) + " twice");
    }

    /**
     * The list for one exercise.
     *
     * @param contract the interface that a student's class implements
     */
    public static AllowList of(Class<?> contract) {
        return new AllowList(text(), ContractTypes.of(contract));
    }

    /** The part that is the same for every exercise. */
    public static String text() {
        try (InputStream in = AllowList.class.getResourceAsStream(FILE)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Whether the class may be mentioned.
     *
     * @param type internal name, such as "java/util/List"
     */
    boolean allows(String type) {
        return members.containsKey(type);
    }

    /** Whether that method, field or constructor of the class may be used. */
    boolean allows(String type, String member) {
        Set<String> words = members.getOrDefault(type, Set.of());
        return words.contains(member) || words.contains("*") && !words.contains("-" + member);
    }

    /** All methods and fields that may be used, sorted, where the class has only some. */
    List<String> some(String type) {
        Set<String> words = members.getOrDefault(type, Set.of());
        if (words.contains("*")) return List.of();
        return words.stream().filter(word -> !word.equals("<init>")).sorted().toList();
    }
}
