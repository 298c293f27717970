package rasterlab.app.exercise;

import java.util.ArrayList;
import java.util.List;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.GradingVerdict;

/**
 * One case of a result.
 *
 * @param verdict a code, as in the HTTP API; "" for a case that was not tried yet, or whose verdict
 *     may still change
 * @param said why points were lost
 * @param scene the case as a scene file; "" where it is hidden
 */
record TriedCase(
        String name,
        String verdict,
        int points,
        int of,
        Said said,
        List<TriedPicture> pictures,
        String scene) {
    TriedCase {
        pictures = List.copyOf(pictures);
    }

    static TriedCase of(CaseReport report) {
        return new TriedCase(
                report.name(),
                report.verdict().code(),
                report.points(),
                report.of(),
                Said.of(report::message),
                report.pictures().stream().map(TriedPicture::of).toList(),
                report.scene());
    }

    /** The open cases of an exercise, none of them tried. */
    static List<TriedCase> untried(Exercise exercise) {
        return exercise.cases().stream()
                .filter(one -> one.visibility() == Disclosure.OPEN)
                .map(TriedCase::untried)
                .toList();
    }

    private static TriedCase untried(Exercise.Case one) {
        return new TriedCase(one.name(), "", 0, one.points(), Said.NOTHING, List.of(), "");
    }

    /**
     * The cases, of which those whose own names are kept from the student get numbers, by which
     * they are chosen.
     */
    static List<TriedCase> toldApart(List<TriedCase> cases) {
        var toldApart = new ArrayList<TriedCase>();
        int hidden = 0;
        for (TriedCase one : cases)
            toldApart.add(
                    CaseReport.isHidden(one.name) ? one.called(CaseReport.hidden(++hidden)) : one);
        return List.copyOf(toldApart);
    }

    private TriedCase called(String next) {
        return new TriedCase(next, verdict, points, of, said, pictures, scene);
    }

    TriedCase withoutVerdict() {
        return new TriedCase(name, "", 0, of, Said.NOTHING, List.of(), scene);
    }

    /** Pixels that its pictures show; 0 where it has none. */
    int pixels() {
        return pictures.stream()
                .map(one -> CaseDrawing.pixels(one.rows()))
                .mapToInt(size -> size.width * size.height)
                .max()
                .orElse(0);
    }

    boolean right() {
        return verdict.equals(GradingVerdict.OK.code());
    }
}
