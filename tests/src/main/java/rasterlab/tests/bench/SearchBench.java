package rasterlab.tests.bench;

import java.io.PrintStream;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Stream;
import rasterlab.engine.Topics;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.searching.Find;
import rasterlab.exercises.searching.HazardSearch;
import rasterlab.exercises.searching.SearchListener;
import rasterlab.tests.bench.language.BenchWords;

/**
 * Searches for a failing input of each textbook method and each mutant, which must be found, and of
 * each method that no failure is known of, where none must be.
 */
final class SearchBench {
    private static final SearchListener SILENT =
            new SearchListener() {
                @Override
                public void tried(long inputs) {}

                @Override
                public void found(Find find) {}

                @Override
                public void simpler(Find find) {}
            };

    private final Duration longest;
    private final BenchWords words;
    private final PrintStream out;

    /**
     * @param longest that the search for one method may take
     */
    SearchBench(Duration longest, BenchWords words, PrintStream out) {
        this.longest = longest;
        this.words = words;
        this.out = out;
    }

    /**
     * Searches and prints a line for each method.
     *
     * @param topics whose methods these are
     * @param only text that the topic and the method have, as in "line dda"; empty for all
     * @return whether all textbook methods and mutants failed and none of the methods that promise
     *     to be right did
     */
    boolean run(List<Topic<?, ?, ?>> topics, String only) {
        out.println(words.head("head.search"));
        boolean textbooks = searched(topics, SearchBench::textbooks, only, true);
        boolean mutants = searched(topics, SearchBench::mutants, only, true);
        return searched(topics, SearchBench::right, only, false) && mutants && textbooks;
    }

    /** The topic and method of all that is searched, each as {@code --only} is compared with. */
    static List<String> works() {
        return works(topic -> true);
    }

    /**
     * The works of the topic that a text begins with; none where it begins with no topic's name.
     */
    static List<String> worksOfTopicIn(String text) {
        String first = text.strip().split(" ")[0];
        return works(topic -> topic.name().equals(first));
    }

    /** The names of the topics. */
    static List<String> topics() {
        return Topics.all().stream().<String>map(Topic::name).toList();
    }

    private static List<String> works(Predicate<Topic<?, ?, ?>> chosen) {
        return Topics.all().stream()
                .filter(chosen)
                .flatMap(
                        topic ->
                                Stream.of(textbooks(topic), mutants(topic), right(topic))
                                        .flatMap(List::stream)
                                        .map(method -> topic.name() + " " + method))
                .toList();
    }

    private static List<String> textbooks(Topic<?, ?, ?> topic) {
        return named(topic, method -> method.name().endsWith("-textbook"));
    }

    private static List<String> right(Topic<?, ?, ?> topic) {
        return named(topic, Method::promisesToBeRight);
    }

    private static List<String> named(Topic<?, ?, ?> topic, Predicate<Method<?>> which) {
        return topic.methods().stream().filter(which).<String>map(Method::name).toList();
    }

    private static <C, I, O> List<String> mutants(Topic<C, I, O> topic) {
        List<Mutant<C>> general = topic.mutants();
        return topic.allMutants().stream()
                .filter(mutant -> general.contains(mutant) || isMistaken(topic, mutant))
                .<String>map(Mutant::name)
                .distinct()
                .toList();
    }

    /**
     * Whether a mutant of one method is wrong in the topic too: what is a mistake of Gouraud's
     * shading may be Phong's.
     */
    private static <C, I, O> boolean isMistaken(Topic<C, I, O> topic, Mutant<C> mutant) {
        Method<C> method = Method.failing(mutant.name(), mutant.implementation());
        return topic.hazards().stream()
                .filter(hazard -> hazard.name().equals(mutant.hazard()))
                .map(hazard -> HazardTrial.judge(topic, method, hazard, HazardTrial.WALL_LIMIT))
                .anyMatch(verdict -> verdict.kind() != Verdict.Kind.EXACT);
    }

    private boolean searched(
            List<Topic<?, ?, ?>> topics,
            Function<Topic<?, ?, ?>, List<String>> which,
            String only,
            boolean failing) {
        boolean all = true;
        for (Topic<?, ?, ?> topic : topics)
            for (String method : which.apply(topic))
                if ((topic.name() + " " + method).contains(only))
                    all &= searched(topic.name(), method, failing);
        return all;
    }

    private boolean searched(String topic, String method, boolean failing) {
        HazardSearch<?, ?, ?> search = HazardSearch.of(topic, method, 1, SILENT);
        Optional<Find> find = search.search(longest, () -> false);
        boolean met = find.isPresent() == failing;
        out.printf(
                Locale.ROOT,
                "%s %s | %s | %s | %d | %s%n",
                topic,
                method,
                find.map(one -> words.text("search." + one.verdict().kind().code()))
                        .orElse(words.text("search.nothing")),
                find.map(one -> String.format(Locale.ROOT, "%.1f", one.after().toMillis() / 1e3))
                        .orElse("-"),
                search.inputsTried(),
                words.text(met ? "yes" : "no"));
        return met;
    }
}
