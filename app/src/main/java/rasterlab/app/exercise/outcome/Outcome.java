package rasterlab.app.exercise.outcome;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import rasterlab.engine.range.Bounds;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.published.PublishedSpeed;
import rasterlab.exercises.score.Report;
import rasterlab.exercises.score.ScorePoints;

/**
 * The answer of a check or a server to one source.
 *
 * @param source the text that was tried
 * @param attempt the server's number of the submission; 0 for a check on this machine
 * @param verdict a code, as in the HTTP API
 * @param isolation how the method was shut in
 * @param nanosPerItem 0 where not measured or not told
 * @param earlier whether it was graded against an earlier revision of the exercise than the one
 *     that the server gives now
 * @param hints points that hints cost, which are still in {@code points}
 * @param speed the program's point on the topic's chart; empty where none was measured
 */
public record Outcome(
        String source,
        int attempt,
        String verdict,
        ScorePoints points,
        List<CaseResult> cases,
        List<Remark> remarks,
        LocalizedText isolation,
        double nanosPerItem,
        boolean earlier,
        int hints,
        Optional<PublishedSpeed> speed) {
    /**
     * A message about a place in the source.
     *
     * @param line from 1; 0 where none is known
     * @param column from 1; 0 where none is known
     */
    public record Remark(int line, int column, LocalizedText message) {
        public Remark {
            Bounds.requireAtLeast("line", line, 0);
            Bounds.requireAtLeast("column", column, 0);
        }
    }

    public Outcome {
        cases = CaseResult.numbered(cases);
        remarks = List.copyOf(remarks);
    }

    /** An answer without a chart. */
    Outcome(
            String source,
            int attempt,
            String verdict,
            ScorePoints points,
            List<CaseResult> cases,
            List<Remark> remarks,
            LocalizedText isolation,
            double nanosPerItem,
            boolean earlier,
            int hints) {
        this(
                source,
                attempt,
                verdict,
                points,
                cases,
                remarks,
                isolation,
                nanosPerItem,
                earlier,
                hints,
                Optional.empty());
    }

    /** This outcome with a point on the topic's chart. */
    public Outcome with(Optional<PublishedSpeed> measured) {
        return new Outcome(
                source,
                attempt,
                verdict,
                points,
                cases,
                remarks,
                isolation,
                nanosPerItem,
                earlier,
                hints,
                measured);
    }

    /** An answer that pays for no hints. */
    public Outcome(
            String source,
            int attempt,
            String verdict,
            ScorePoints points,
            List<CaseResult> cases,
            List<Remark> remarks,
            LocalizedText isolation,
            double nanosPerItem,
            boolean earlier) {
        this(source, attempt, verdict, points, cases, remarks, isolation, nanosPerItem, earlier, 0);
    }

    /** The points that are left when hints are paid for. */
    public int total() {
        return Math.max(0, points.total() - hints);
    }

    /** A report of this machine. */
    public static Outcome checked(Exercise exercise, String source, Report report) {
        return new Outcome(
                source,
                0,
                report.verdict().code(),
                report.points(),
                report.cases().stream().map(one -> CaseResult.of(exercise, one)).toList(),
                report.diagnostics().stream()
                        .map(
                                one ->
                                        new Remark(
                                                one.line(),
                                                one.column(),
                                                LocalizedText.of(one::message)))
                        .toList(),
                LocalizedText.of(report::isolation),
                report.nanosPerItem(),
                false);
    }

    /**
     * Whether this one and that were said to the same text, and judge the case of that name alike.
     */
    public boolean agrees(Outcome other, String name) {
        return source.equals(other.source) && verdictOf(name).equals(other.verdictOf(name));
    }

    private Optional<String> verdictOf(String name) {
        return cases.stream()
                .filter(one -> one.name().equals(name))
                .map(CaseResult::verdict)
                .findFirst();
    }

    /** The case with the smallest picture of those that went wrong and can be drawn. */
    public Optional<CaseResult> smallestCounterexample() {
        return cases.stream()
                .filter(one -> !one.right() && !one.pictures().isEmpty())
                .min(Comparator.comparingInt(CaseResult::pixels));
    }

    /**
     * The case that tells most of what went wrong: the smallest counterexample; where nothing can
     * be drawn, the first that went wrong, since those after a method was stopped were not run.
     */
    public Optional<CaseResult> mostTelling() {
        return smallestCounterexample()
                .or(() -> cases.stream().filter(one -> !one.right()).findFirst());
    }
}
