package rasterlab.app.exercise;

import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.score.CasePictures;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.PicturePart;

/**
 * One case of a result.
 *
 * @param verdict a code, as in the HTTP API; "" for a case that was not tried yet
 * @param said why points were lost
 * @param scene the case as a scene file; "" where it is hidden
 */
record TriedCase(
        String name,
        String verdict,
        int points,
        int of,
        Said said,
        Optional<Pictures> pictures,
        String scene) {
    /**
     * Right, drawn, and where they differ, each as PNG.
     *
     * @param text rows of characters, as {@link CasePictures#text}
     */
    record Pictures(byte[] expected, byte[] actual, byte[] difference, String text) {
        private static Pictures of(CasePictures drawn) {
            return new Pictures(
                    drawn.expectedPng(), drawn.actualPng(), drawn.differencePng(), drawn.text());
        }

        /** Columns and rows of all that was drawn or expected, of which a part may be kept. */
        List<Long> whole() {
            Dimension kept = pixels();
            return PicturePart.of(text)
                    .map(part -> List.of(part.width(), part.height()))
                    .orElse(List.of((long) kept.width, (long) kept.height));
        }

        /** Number of pixels of the box that holds both pictures. */
        int size() {
            return pixels().width * pixels().height;
        }

        /** Of that box, across and down. */
        Dimension pixels() {
            List<String> rows = PicturePart.rows(text);
            int across = rows.stream().mapToInt(String::length).max().orElse(0);
            return new Dimension(across, rows.size());
        }
    }

    static TriedCase of(CaseReport report) {
        return new TriedCase(
                report.name(),
                report.verdict().code(),
                report.points(),
                report.of(),
                Said.of(report::message),
                report.pictures().map((Function<CasePictures, Pictures>) Pictures::of),
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
        return new TriedCase(one.name(), "", 0, one.points(), Said.NOTHING, Optional.empty(), "");
    }

    /** Those whose own names are kept from the student get numbers, by which they are chosen. */
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

    boolean right() {
        return verdict.equals(GradingVerdict.OK.code());
    }
}
