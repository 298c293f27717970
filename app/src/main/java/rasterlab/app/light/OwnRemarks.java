package rasterlab.app.light;

import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.language.Texts;
import rasterlab.app.light.step.OwnSteps;
import rasterlab.app.mine.OwnMethods;

/**
 * The remarks on the user's own program beside a picture.
 *
 * @param refusal why it gave no answer, in English; "" where it did
 * @param key of the sentence on its answers, in the lab's texts; "" where there is a refusal
 * @param wrong number of wrong answers
 * @param of number of all
 * @param worst levels of 255 by which one is off
 * @param first the first wrong normal; empty where there is none
 * @param light that it finds at the chosen point: red, green and blue; empty where it finds none
 * @param steps its answers one by one; empty where there are none
 */
public record OwnRemarks(
        String refusal,
        String key,
        long wrong,
        long of,
        double worst,
        Optional<WrongNormal> first,
        Optional<double[]> light,
        Optional<OwnSteps> steps) {
    /** A normal that is not the right one. */
    record WrongNormal(int vertex, double[] mine, double[] right) {}

    static OwnRemarks refused(String refusal) {
        return new OwnRemarks(
                refusal, "", 0, 0, 0, Optional.empty(), Optional.empty(), Optional.empty());
    }

    static OwnRemarks ofNormals(long wrong, long of, Optional<WrongNormal> first, OwnSteps steps) {
        String key = wrong == 0 ? "own.normals.right" : "own.normals.off";
        return new OwnRemarks("", key, wrong, of, 0, first, Optional.empty(), Optional.of(steps));
    }

    static OwnRemarks ofLight(
            long wrong, long of, double worst, Optional<double[]> light, OwnSteps steps) {
        String key = wrong == 0 ? "own.light.right" : "own.light.off";
        return new OwnRemarks(
                "", key, wrong, of, worst, Optional.empty(), light, Optional.of(steps));
    }

    /** The sentence in the language of the lab's texts. */
    public String in(Texts texts) {
        if (!refusal.isEmpty())
            return OwnWords.refusal(OwnMethods.NAME, refusal, texts.language()).orElseThrow();
        String all = Long.toString(of);
        String bad = Long.toString(wrong);
        return first.map(
                        one ->
                                texts.text(
                                        key,
                                        all,
                                        bad,
                                        Integer.toString(one.vertex()),
                                        numbers(one.mine(), texts),
                                        numbers(one.right(), texts)))
                .orElseGet(() -> texts.text(key, all, bad, Shown.number(worst, 1, texts.locale())));
    }

    private static String numbers(double[] normal, Texts texts) {
        return DoubleStream.of(normal)
                .mapToObj(number -> Shown.number(number, 3, texts.locale()))
                .collect(Collectors.joining(Shown.apart(texts.locale()), "(", ")"));
    }
}
