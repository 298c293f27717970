package rasterlab.exercises.graded;

import java.util.List;
import rasterlab.contract.FaceShader;
import rasterlab.engine.light.face.FacePoints;
import rasterlab.engine.light.face.FaceTopic;
import rasterlab.exercises.drawing.Agreement;
import rasterlab.exercises.drawing.TableLabels;
import rasterlab.exercises.drawing.TablePictures;
import rasterlab.exercises.judging.ByTopic;
import rasterlab.exercises.score.CasePicture;

/** Grades the topic {@code shade-face}; shows the three shares of each point in a table. */
public final class FaceGrading extends ByTopic<FaceShader, FacePoints, double[]> {
    /** A hundredth of a level of 255: less is not marked. */
    private static final double SEEN = 0.01 / 255;

    public FaceGrading() {
        super(new FaceTopic());
    }

    @Override
    protected List<CasePicture> pictures(FacePoints input, double[] exact, double[] actual) {
        return TablePictures.of(
                new TableLabels(List.of(), List.of("R", "G", "B")),
                rows(exact),
                rows(actual),
                Agreement.within(SEEN));
    }

    private static double[][] rows(double[] shades) {
        var rows = new double[shades.length / 3][];
        for (int i = 0; i < rows.length; i++)
            rows[i] = new double[] {shades[3 * i], shades[3 * i + 1], shades[3 * i + 2]};
        return rows;
    }
}
