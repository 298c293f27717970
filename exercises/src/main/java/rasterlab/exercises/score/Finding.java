package rasterlab.exercises.score;

import java.util.List;

/**
 * The finding about one answer.
 *
 * @param message what is wrong; nothing when nothing is
 * @param pictures that show it; none where nothing can be shown
 * @param explanations of a wrong answer, each some mistakes that together explain it; several where
 *     it cannot be told which they are
 */
public record Finding(
        GradingVerdict verdict,
        Message message,
        List<CasePicture> pictures,
        List<List<Cause>> explanations) {
    public static final Finding OK = of(GradingVerdict.OK, Message.NONE);

    public Finding {
        pictures = List.copyOf(pictures);
        explanations = List.copyOf(explanations);
    }

    /** A finding without pictures. */
    public static Finding of(GradingVerdict verdict, Message said) {
        return of(verdict, said, List.of());
    }

    /** A finding with what explains it. */
    public static Finding of(GradingVerdict verdict, Message said, List<List<Cause>> explanations) {
        return new Finding(verdict, said, List.of(), explanations);
    }

    /** This finding with more to be said. */
    public Finding and(Message more) {
        return more.isEmpty()
                ? this
                : new Finding(verdict, message.and(more), pictures, explanations);
    }

    public boolean right() {
        return verdict == GradingVerdict.OK;
    }
}
