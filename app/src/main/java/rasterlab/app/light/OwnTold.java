package rasterlab.app.light;

import java.util.Optional;
import rasterlab.app.canvas.OwnWords;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.VerdictDetail;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.study.Deviation;

/**
 * What there is to say of the user's own program beside a picture.
 *
 * @param refusal why it gave no answer, in English; "" where it did
 * @param key of the sentence on its answers, in the lab's texts; "" where there is a refusal
 * @param wrong number of wrong answers
 * @param of number of all
 * @param worst levels of 255 by which one is off
 * @param first the first wrong answer, in English; "" where that is seen in the picture
 * @param light that it finds at the chosen point: red, green and blue; empty where it finds none
 */
record OwnTold(
        String refusal,
        String key,
        long wrong,
        long of,
        double worst,
        String first,
        Optional<double[]> light) {
    static OwnTold refused(String refusal) {
        return new OwnTold(refusal, "", 0, 0, 0, "", Optional.empty());
    }

    /**
     * @param right the largest error that is none
     */
    static OwnTold ofNormals(Deviation off, double right) {
        return off.worst() <= right
                ? new OwnTold("", "own.normals.right", 0, off.of(), 0, "", Optional.empty())
                : new OwnTold("", "own.normals.off", 0, off.of(), 0, off.first(), Optional.empty());
    }

    static OwnTold ofLight(long wrong, long of, double worst, Optional<double[]> light) {
        String key = wrong == 0 ? "own.light.right" : "own.light.off";
        return new OwnTold("", key, wrong, of, worst, "", light);
    }

    /** The sentence in the language of the lab's texts. */
    String in(Texts texts) {
        if (!refusal.isEmpty())
            return OwnWords.refusal(OwnMethods.NAME, refusal, texts.language()).orElseThrow();
        if (!first.isEmpty()) return texts.text(key, VerdictDetail.said(texts.language(), first));
        return texts.text(
                key,
                Long.toString(of),
                Long.toString(wrong),
                Shown.number(worst, 1, texts.locale()));
    }
}
