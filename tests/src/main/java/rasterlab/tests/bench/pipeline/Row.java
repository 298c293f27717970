package rasterlab.tests.bench.pipeline;

import java.util.Locale;
import java.util.function.Function;
import rasterlab.tests.bench.language.BenchWords;

/**
 * One line of the table.
 *
 * @param work what both do
 * @param ours our time
 * @param peer the peer's name and time
 * @param ratio the peer's time divided by ours
 * @param goal the least ratio wanted, 0 for none
 * @param note what else was seen
 */
record Row(
        String work,
        String ours,
        String peer,
        double ratio,
        double goal,
        Function<BenchWords, String> note) {
    static Row without(String work, String missing) {
        return new Row(work, "–", "–", Double.NaN, 0, words -> missing);
    }

    String line(BenchWords words) {
        boolean judged = goal > 0 && !Double.isNaN(ratio);
        return String.format(
                Locale.ROOT,
                "%s | %s | %s | %s | %s | %s | %s",
                work,
                ours,
                peer,
                Double.isNaN(ratio) ? "–" : String.format(Locale.ROOT, "%.2f", ratio),
                goal > 0 ? String.format(Locale.ROOT, "%.2f", goal) : "–",
                judged ? words.text(ratio >= goal ? "yes" : "no") : "–",
                note.apply(words));
    }
}
