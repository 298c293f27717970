package rasterlab.exercises.score;

import java.math.BigDecimal;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.UnaryOperator;

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

    /** Times up to this factor beyond a band's end may belong to the band. */
    private static final double TOLERANCE = 1.1;

    /** A method that was in a band stays there up to so much beyond its end. */
    private static final double STAYS = 1.3;

    private static final String UNSETTLED = "speed.unsettled";

    /** Key of the text where it is known to be slow. */
    private static final String UNSETTLED_SLOW = "speed.unsettled-slow";

    private static final Set<String> KEYS_UNSETTLED = Set.of(UNSETTLED, UNSETTLED_SLOW);

    private SpeedPoints() {}

    /**
     * Number of the band, 0 being the best, for that many times the reference's time.
     *
     * @param before the band of the same source when it was last measured
     */
    public static int band(double ratio, OptionalInt before) {
        int band = 0;
        while (band < BANDS.size() && ratio > end(band, before)) band++;
        return band;
    }

    private static double end(int band, OptionalInt before) {
        boolean wasThere = before.isPresent() && before.getAsInt() <= band;
        return BANDS.get(band).upTo() * (wasThere ? STAYS : TOLERANCE);
    }

    /** Whether all ratios from the one to the other are in the same band. */
    public static boolean isOneBand(double low, double high) {
        return band(low, OptionalInt.empty()) == band(high, OptionalInt.empty());
    }

    /** Whether a further measurement might lead to another band. */
    public static boolean isNearAnEnd(double ratio) {
        return BANDS.stream()
                .anyMatch(band -> ratio > band.upTo() / TOLERANCE && ratio < band.upTo() * STAYS);
    }

    /**
     * The line of the report on speed.
     *
     * @param words the key of a text in the topic's words
     * @param nanos the student's time per item, above 0
     * @param reference that of the reference
     * @param printed whether the method printed while it was measured
     * @param band as {@link #band} has it
     */
    public static CaseReport measured(
            UnaryOperator<String> words,
            double nanos,
            double reference,
            boolean printed,
            int of,
            int band) {
        int points = points(band, of);
        boolean worthless = points == 0 && of > 0;
        Message said =
                Message.of(
                        words.apply(worthless ? "speed.worthless" : "speed.measured"),
                        twoPlaces(nanos),
                        twoPlaces(reference),
                        twoPlaces(nanos / reference),
                        limit(BANDS.get(0)),
                        limit(BANDS.get(BANDS.size() - 1)));
        boolean printingCost = printed && points < of;
        return report(
                worthless ? GradingVerdict.TOO_SLOW : GradingVerdict.OK,
                points,
                of,
                printingCost ? said.and(Message.of("speed.printing")) : said);
    }

    /** The largest ratio that earns all points. */
    public static double fullUpTo() {
        return BANDS.get(0).upTo();
    }

    /** The ratio above which there are no points. */
    public static double noneAbove() {
        return BANDS.get(BANDS.size() - 1).upTo();
    }

    private static String limit(Band band) {
        return BigDecimal.valueOf(band.upTo()).stripTrailingZeros().toPlainString();
    }

    private static String twoPlaces(double number) {
        return String.format(Locale.ROOT, "%.2f", number);
    }

    /**
     * The line of the report where the machine let nothing be measured exactly. It costs points
     * only where the method is slow for certain.
     *
     * @param band the best that is possible by what is known
     */
    public static CaseReport unsettled(int of, int band) {
        int points = points(band, of);
        Message said =
                points == of ? Message.of(UNSETTLED) : Message.of(UNSETTLED_SLOW, points, of);
        return report(GradingVerdict.NOT_MEASURED, points, of, said);
    }

    /** Whether that is the line of a speed which the machine did not let be measured. */
    static boolean isUnsettled(CaseReport one) {
        return one.name().equals(CaseReport.SPEED)
                && one.explanation().sentences().stream()
                        .anyMatch(said -> KEYS_UNSETTLED.contains(said.key()));
    }

    /** Whether that is the line of a speed that no machine would let be measured. */
    static boolean isObstacle(CaseReport one) {
        return one.verdict() == GradingVerdict.NOT_MEASURED && !isUnsettled(one);
    }

    private static int points(int band, int of) {
        return band < BANDS.size() ? (int) Math.round(BANDS.get(band).share() * of) : 0;
    }

    /** Where speed was not measured, or is worth nothing yet. */
    public static CaseReport none(int of, Message reason) {
        return report(GradingVerdict.NOT_MEASURED, 0, of, reason);
    }

    private static CaseReport report(GradingVerdict verdict, int points, int of, Message said) {
        return new CaseReport(
                CaseReport.SPEED, Disclosure.OPEN, verdict, points, of, said, List.of(), "");
    }
}
