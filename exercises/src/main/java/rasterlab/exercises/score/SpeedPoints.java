package rasterlab.exercises.score;

import java.math.BigDecimal;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Points for speed, in bands, because a measured time is never the same twice. */
public final class SpeedPoints {
    /** The share of the accuracy points below which speed is worth nothing. */
    public static final double ACCURACY_FLOOR = 0.8;

    /**
     * A band.
     *
     * @param upTo the largest ratio of the student's time to the reference's
     * @param share of the points
     */
    private record Band(double upTo, double share) {}

    private static final List<Band> BANDS =
            List.of(new Band(1.5, 1), new Band(3, 0.7), new Band(8, 0.4));

    private SpeedPoints() {}

    /**
     * The line of the report on speed.
     *
     * @param nanos the student's time per pixel, above 0
     * @param reference that of the reference
     * @param printed whether the method printed while it was measured
     */
    public static CaseReport measured(double nanos, double reference, boolean printed, int of) {
        double ratio = nanos / reference;
        int points =
                BANDS.stream()
                        .filter(band -> ratio <= band.upTo())
                        .findFirst()
                        .map(band -> (int) Math.round(band.share() * of))
                        .orElse(0);
        boolean worthless = points == 0 && of > 0;
        Message said =
                Message.of(
                        worthless ? "speed.worthless" : "speed.measured",
                        twoPlaces(nanos),
                        twoPlaces(reference),
                        twoPlaces(ratio),
                        limit(BANDS.get(0)),
                        limit(BANDS.get(BANDS.size() - 1)));
        boolean printingCost = printed && points < of;
        return report(
                worthless ? GradingVerdict.TOO_SLOW : GradingVerdict.OK,
                points,
                of,
                printingCost ? said.and(Message.of("speed.printing")) : said);
    }

    private static String limit(Band band) {
        return BigDecimal.valueOf(band.upTo()).stripTrailingZeros().toPlainString();
    }

    private static String twoPlaces(double number) {
        return String.format(Locale.ROOT, "%.2f", number);
    }

    /** Where speed was not measured, or is worth nothing yet. */
    public static CaseReport none(int of, Message reason) {
        return report(GradingVerdict.NOT_MEASURED, 0, of, reason);
    }

    private static CaseReport report(GradingVerdict verdict, int points, int of, Message said) {
        return new CaseReport(
                CaseReport.SPEED, Disclosure.OPEN, verdict, points, of, said, Optional.empty(), "");
    }
}
