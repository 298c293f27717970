package rasterlab.tests.rules;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * A class of tests as its text, in Java or Kotlin: its tests, and the cases of those that have
 * many.
 */
final class TestText {
    /** A declaration as formatters indent it: of a class, or of its companion. */
    private static final Pattern DECLARATION =
            Pattern.compile(
                    "(?m)^ {4}(?: {4}(?=.*\\bfun ))?(?:[\\w<>\\[\\],.?]+ )+(?:\\w+\\.)?(\\w+)(?:\\(| =|:|;)");

    private static final Pattern SOURCES = Pattern.compile("@MethodSource\\(([^)]*)\\)");
    private static final Pattern TEST = Pattern.compile("@(?:Parameterized)?Test\\b");
    private static final Pattern WORD = Pattern.compile("\\w+");
    private static final Pattern DISPLAY =
            Pattern.compile("@ParameterizedTest\\(\\s*name\\s*=\\s*\"((?:[^\"\\\\]|\\\\.)*)\"");

    /** Place of a value in the name of a case; the first value tells the cases apart. */
    private static final Pattern VALUE = Pattern.compile("\\{[^}]*\\}");

    /** A member of the class: its text, and the annotations before its declaration. */
    private record Member(String name, String annotations, String text) {}

    private final List<Member> members = new ArrayList<>();

    TestText(String text) {
        List<MatchResult> found = DECLARATION.matcher(text).results().toList();
        for (int i = 0; i < found.size(); i++) {
            int begins = begins(text, found.get(i));
            int ends = i + 1 < found.size() ? begins(text, found.get(i + 1)) : text.length();
            String annotations = text.substring(begins, found.get(i).start());
            if (begins < ends)
                members.add(
                        new Member(
                                found.get(i).group(1), annotations, text.substring(begins, ends)));
        }
    }

    /** Members stand apart by an empty line; annotations and comments stand before the name. */
    private static int begins(String text, MatchResult declaration) {
        return Math.max(0, text.lastIndexOf("\n\n", declaration.start()));
    }

    boolean hasTest(String name) {
        return test(name, "@Test").isPresent();
    }

    boolean hasCases(String name) {
        return test(name, "@ParameterizedTest").isPresent();
    }

    /** Whether a test has a case that the report calls by that name. */
    boolean hasCase(String test, String name) {
        Optional<Member> found = test(test, "@ParameterizedTest");
        if (found.isEmpty()) return false;
        Matcher display = DISPLAY.matcher(found.get().annotations());
        if (!display.find()) return false;
        String[] around = VALUE.split(display.group(1).translateEscapes(), -1);
        Pattern shape =
                Pattern.compile(
                        List.of(around).stream()
                                .map(Pattern::quote)
                                .collect(Collectors.joining("(.*)")));
        Matcher values = shape.matcher(name);
        return values.matches() && values.groupCount() > 0 && isFed(found.get(), values.group(1));
    }

    private Optional<Member> test(String name, String annotation) {
        return members.stream()
                .filter(one -> one.name().equals(name) && one.annotations().contains(annotation))
                .findFirst();
    }

    /** Whether that value stands in what the test is fed with: a number, or the start of a text. */
    private boolean isFed(Member test, String value) {
        Pattern number = Pattern.compile("[\\[\" ]" + Pattern.quote(value) + "[,\\]\"]");
        Pattern start = Pattern.compile("\"" + Pattern.quote(value) + "(?:\"|, | \\|)");
        Pattern wanted = value.matches("-?\\d+") ? number : start;
        return feeds(test).stream().anyMatch(text -> wanted.matcher(text).find());
    }

    /** The test's annotations, its sources, and all that these name within the class. */
    private Collection<String> feeds(Member test) {
        Set<String> texts = new LinkedHashSet<>(List.of(test.annotations()));
        var left = new ArrayDeque<Member>();
        Matcher sources = SOURCES.matcher(test.annotations());
        if (sources.find()) left.addAll(named(sources.group(1)));
        while (!left.isEmpty()) {
            Member one = left.pop();
            if (texts.add(one.text())) left.addAll(named(one.text()));
        }
        return texts;
    }

    /** The members, but for tests, whose names stand in a text. */
    private List<Member> named(String text) {
        Set<String> words =
                WORD.matcher(text).results().map(MatchResult::group).collect(Collectors.toSet());
        return members.stream()
                .filter(one -> words.contains(one.name()))
                .filter(one -> !TEST.matcher(one.annotations()).find())
                .toList();
    }
}
