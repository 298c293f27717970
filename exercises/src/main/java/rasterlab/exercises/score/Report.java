package rasterlab.exercises.score;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The whole answer to a submission, with nothing hidden.
 *
 * @param verdict {@code OK} if every case is right, else that of the first case that is not
 * @param diagnostics compiler messages and refusals
 * @param isolation how the method was shut in, such as "bubblewrap" or "process limits only", for
 *     the result page
 * @param nanosPerItem measured cost per item, 0 where not measured
 * @param figures that cost beside those of the topic's methods; empty where not measured
 */
public record Report(
        GradingVerdict verdict,
        ScorePoints points,
        List<CaseReport> cases,
        List<Diagnostic> diagnostics,
        String isolation,
        double nanosPerItem,
        Optional<SpeedFigures> figures) {
    /** Names of what shuts a method in, as they are stored. */
    public static final String BUBBLEWRAP = "bubblewrap";

    public static final String PROCESS_LIMITS = "process limits only";

    public Report {
        cases = List.copyOf(cases);
        diagnostics = List.copyOf(diagnostics);
    }

    /** A report without figures. */
    public Report(
            GradingVerdict verdict,
            ScorePoints points,
            List<CaseReport> cases,
            List<Diagnostic> diagnostics,
            String isolation,
            double nanosPerItem) {
        this(verdict, points, cases, diagnostics, isolation, nanosPerItem, Optional.empty());
    }

    /** This report with figures on its speed. */
    public Report with(Optional<SpeedFigures> measured) {
        return new Report(verdict, points, cases, diagnostics, isolation, nanosPerItem, measured);
    }

    /**
     * This report with one case as another run judged it; all else stays, what is said of the speed
     * and what is withheld included.
     *
     * @param again its line there, of a name that is here too
     * @param stability whether the case earns stability, and not accuracy
     */
    public Report withCase(CaseReport again, boolean stability) {
        int place = cases.stream().map(CaseReport::name).toList().indexOf(again.name());
        if (place < 0)
            throw new IllegalArgumentException("the report has no case '" + again.name() + "'");
        int gained = again.points() - cases.get(place).points();
        List<CaseReport> all = new ArrayList<>(cases);
        all.set(place, again);
        GradingVerdict first =
                all.stream()
                        .filter(CaseReport::isOfExercise)
                        .map(CaseReport::verdict)
                        .filter(one -> one != GradingVerdict.OK)
                        .map(GradingVerdict::published)
                        .findFirst()
                        .orElse(GradingVerdict.OK);
        ScorePoints changed =
                new ScorePoints(
                        points.accuracy() + (stability ? 0 : gained),
                        points.stability() + (stability ? gained : 0),
                        points.speed(),
                        points.of());
        return new Report(first, changed, all, diagnostics, isolation, nanosPerItem, figures);
    }

    /** The report's line on speed; empty where nothing was run. */
    public Optional<CaseReport> speed() {
        return cases.stream().filter(one -> one.name().equals(CaseReport.SPEED)).findFirst();
    }

    /** Whether the speed is worth another try, since the machine did not let it be measured. */
    public boolean speedIsUnsettled() {
        return speed().filter(SpeedPoints::isUnsettled).isPresent();
    }

    /** Why the speed of a method that is accurate enough cannot be measured; else nothing. */
    public Message speedObstacle() {
        return speed().filter(SpeedPoints::isObstacle)
                .map(CaseReport::explanation)
                .orElse(Message.NONE);
    }

    /** {@link #isolation} in that language. */
    public String isolation(String language) {
        return isolationIn(language, isolation);
    }

    /**
     * The stored name of an isolation in that language; as it is where it has no translation.
     *
     * @param language such as "ru"
     */
    public static String isolationIn(String language, String stored) {
        return stored.equals(PROCESS_LIMITS)
                ? Message.of("isolation.process-limits").in(language)
                : stored;
    }

    /**
     * This report with what the student may not see taken out: of a hidden case only the class of
     * the error is left, and of one that is never shown not even the name.
     */
    public Report forStudent(boolean afterDeadline) {
        return new Report(
                verdict,
                points,
                cases.stream().map(one -> one.forStudent(afterDeadline)).toList(),
                diagnostics,
                isolation,
                nanosPerItem,
                figures);
    }
}
