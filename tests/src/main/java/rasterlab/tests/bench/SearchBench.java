package rasterlab.tests.bench;

import java.io.PrintStream;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.searching.Find;
import rasterlab.exercises.searching.HazardSearch;
import rasterlab.exercises.searching.SearchListener;
import rasterlab.tests.bench.language.BenchWords;

/**
 * Searches for a failing input of each textbook method, which must be found, and of each method
 * that no failure is known of, where none must be.
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
     * @return whether all textbook methods failed and none of those that promise to be right did
     */
    boolean run() {
        return run(Topics.all());
    }

    boolean run(List<Topic<?, ?, ?>> topics) {
        out.println(words.head("head.search"));
        boolean textbooks = searched(topics, SearchBench::isTextbook, true);
        return searched(topics, Method::promisesToBeRight, false) && textbooks;
    }

    private static boolean isTextbook(Method<?> method) {
        return method.name().endsWith("-textbook");
    }

    private boolean searched(
            List<Topic<?, ?, ?>> topics, Predicate<Method<?>> which, boolean failing) {
        boolean all = true;
        for (Topic<?, ?, ?> topic : topics)
            for (Method<?> method : topic.methods())
                if (which.test(method)) all &= searched(topic.name(), method.name(), failing);
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
