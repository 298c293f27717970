package rasterlab.app.light;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.app.light.step.LightSteps;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.color.Levels;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.study.WrongLength;
import rasterlab.engine.visibility.SeenPoint;

/**
 * The light that the user's own program finds, beside the right one, at as many points of a picture
 * as it can be asked for while something is dragged: each is shown as a square of pixels.
 *
 * @param mine by the program; where it gave no answer, the right one
 * @param right by the formula
 * @param off where they differ: grey where they do not
 * @param remarks what there is to say of it
 */
record OwnLight(Raster mine, Raster right, Raster off, OwnRemarks remarks) {
    /** Levels of 255 from which on a difference is marked: less is no other colour. */
    private static final double MARKED = 0.5;

    /** Levels from which on a mark is no stronger. */
    private static final double STRONGEST = 64;

    private static final int SAME = 0x8C8C8C;
    private static final int OTHER = 0xD55E00;

    /** The colour of pixels that are not answered yet, in a picture up to a step. */
    private static final int OPEN = 0xFF3C4148;

    /**
     * @param places of the choice's body
     * @param at the pixel whose formula is shown
     * @throws CancellationException soon after {@code cancelled} says true
     */
    static OwnLight of(
            LightChoice choice,
            PicturePlaces places,
            int background,
            int[] at,
            OwnMethods own,
            BooleanSupplier cancelled) {
        LightAtPoints light = LightAtPoints.of(choice, places.view());
        LitSamples samples = LitSamples.of(places.view(), light.most());
        double[] right = light.right(own, samples.points(), cancelled);
        Raster shown = samples.picture(background, k -> color(right, k));
        try {
            double[] mine = light.by(own, samples.points(), cancelled);
            Optional<double[]> here =
                    SeenPoint.at(places.view(), at[0], at[1])
                            .map(point -> light.by(own, List.of(point), cancelled));
            LightSteps steps =
                    LightSteps.of(
                            samples.points(),
                            mine,
                            right,
                            color -> samples.picture(background, color));
            return new OwnLight(
                    samples.picture(background, k -> color(mine, k)),
                    shown,
                    samples.picture(background, k -> mark(difference(mine, right, k))),
                    remarks(here, steps));
        } catch (WrongLength length) {
            return refused(samples, background, shown, OwnMethods.misshapen(length));
        } catch (IllegalArgumentException refusal) {
            return refused(samples, background, shown, refusal);
        }
    }

    /** The light of a program that gave no answer, of which nothing is seen. */
    private static OwnLight refused(
            LitSamples samples, int background, Raster right, IllegalArgumentException why) {
        Raster none = samples.picture(background, k -> 0xFF000000 | SAME);
        return new OwnLight(none, right, none, OwnRemarks.refused(why.getMessage()));
    }

    private static int color(double[] light, int k) {
        return Levels.rgb(light[3 * k], light[3 * k + 1], light[3 * k + 2]);
    }

    /**
     * The difference in levels of 255; as much as there can be where the program says no number.
     */
    private static double difference(double[] mine, double[] right, int k) {
        double worst = 0;
        for (int c = 3 * k; c < 3 * k + 3; c++) {
            double off = Levels.HIGHEST * Math.abs(mine[c] - right[c]);
            worst = Math.max(worst, Double.isNaN(off) ? Levels.HIGHEST : off);
        }
        return worst;
    }

    private static int mark(double levels) {
        if (levels < MARKED) return 0xFF000000 | SAME;
        double share = 0.4 + 0.6 * Math.min(1, levels / STRONGEST);
        double[] same = Levels.shares(SAME);
        double[] other = Levels.shares(OTHER);
        var mixed = new double[3];
        for (int c = 0; c < 3; c++) mixed[c] = same[c] + share * (other[c] - same[c]);
        return Levels.rgb(mixed[0], mixed[1], mixed[2]);
    }

    /** The pictures of a program's light and of its difference up to a step. */
    static List<Raster> upTo(int step, LightSteps steps) {
        return List.of(
                steps.picture(step, k -> color(steps.mine(), k), OPEN),
                steps.picture(step, k -> mark(difference(steps.mine(), steps.right(), k)), OPEN));
    }

    private static OwnRemarks remarks(Optional<double[]> here, LightSteps steps) {
        long wrong = 0;
        double worst = 0;
        for (int k = 0; k < steps.count(); k++) {
            double levels = difference(steps.mine(), steps.right(), k);
            worst = Math.max(worst, levels);
            if (levels >= MARKED) wrong++;
        }
        return OwnRemarks.ofLight(wrong, steps.count(), worst, here, steps);
    }
}
