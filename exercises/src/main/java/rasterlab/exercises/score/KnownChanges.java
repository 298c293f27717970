package rasterlab.exercises.score;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import rasterlab.engine.raster.PixelRecording;

/**
 * Finds the changes by which a wrong answer comes from the right one. They tell a mistake that no
 * topic lists: a change is told only where all of the answer comes by it, and so much of it that
 * this is no chance.
 */
public final class KnownChanges {
    private static final String CODE = "changed-";
    private static final String SCALED = CODE + "scaled-";
    private static final String IN_FLOAT = "float";
    private static final String NOT_CUT = "not-cut-at-1";

    /** Values of an answer that agree by chance in no two answers. */
    private static final int ENOUGH = 3;

    /** Factors that a forgotten or wrong unit, root, half or byte leaves, as students read them. */
    private static final Map<String, Double> FACTORS = factors();

    /** The part of a number to which a float keeps it. */
    private static final double FLOAT = 0x1p-20;

    private KnownChanges() {}

    private static Map<String, Double> factors() {
        Map<String, Double> factors = new LinkedHashMap<>();
        for (int one : new int[] {2, 3, 4, 6, 10, 60, 100, 255, 256, 360}) {
            factors.put("" + one, (double) one);
            factors.put("1/" + one, 1.0 / one);
        }
        factors.put("π/180", Math.PI / 180);
        factors.put("180/π", 180 / Math.PI);
        return factors;
    }

    /** The changes of lists of numbers or truth values; none where too little is answered. */
    public static List<Cause> of(JsonNode rightAnswer, JsonNode answer) {
        AnswerTable right = AnswerTable.of(rightAnswer);
        AnswerTable actual = AnswerTable.of(answer);
        if (right.values().count() < ENOUGH) return List.of();
        List<Cause> found = new ArrayList<>();
        for (Change one : Change.values()) {
            AnswerTable changed = one.of(right);
            if (changed.isSameAs(actual) && !changed.isSameAs(right) && tells(one, right))
                found.add(cause(one.word()));
        }
        if (right.magnitudes() >= 2) scaled(right, actual).forEach(found::add);
        if (isInFloat(right, actual)) found.add(cause(IN_FLOAT));
        if (isNotCut(right, actual)) found.add(cause(NOT_CUT));
        return found;
    }

    /** The changes of pixels in any order. */
    public static List<Cause> of(PixelRecording right, PixelRecording actual) {
        return PixelChange.of(right, actual).map(KnownChanges::cause).toList();
    }

    /** Whether that is the code of a change, not of a known method's mistake. */
    public static boolean isOne(String code) {
        return code.startsWith(CODE);
    }

    /** Whether the right answer is still right with the change of that code. */
    public static boolean leaves(String code, JsonNode rightAnswer) {
        AnswerTable right = AnswerTable.of(rightAnswer);
        if (code.startsWith(SCALED)) return right.magnitudes() == 0;
        return Stream.of(Change.values())
                .filter(one -> code.equals(CODE + one.word()))
                .allMatch(one -> one.of(right).isSameAs(right));
    }

    /** Whether these pixels are still right with the change of that code. */
    public static boolean leaves(String code, PixelRecording right) {
        return PixelChange.leaves(code.substring(CODE.length()), right);
    }

    /** Whether a wrong answer comes by the change of that code, however little is answered. */
    public static boolean makes(String code, JsonNode rightAnswer, JsonNode answer) {
        AnswerTable right = AnswerTable.of(rightAnswer);
        AnswerTable actual = AnswerTable.of(answer);
        if (code.startsWith(SCALED))
            return scaled(right, code.substring(SCALED.length())).isSameAs(actual);
        if (code.equals(CODE + IN_FLOAT))
            return actual.isSameAs(right, FLOAT) && actual.allNumbers(KnownChanges::isFloat);
        if (code.equals(CODE + NOT_CUT)) return isNotCut(right, actual);
        return Stream.of(Change.values())
                .filter(one -> code.equals(CODE + one.word()))
                .allMatch(one -> one.of(right).isSameAs(actual));
    }

    /** Whether wrong pixels come by the change of that code, however few they are. */
    public static boolean makes(String code, PixelRecording right, PixelRecording actual) {
        return PixelChange.makes(code.substring(CODE.length()), right, actual);
    }

    private static Cause cause(String word) {
        return new Cause(CODE + word, Message.of("known-mistake", "change." + word));
    }

    /** Whether the change of just this answer is not another one as well as this. */
    private static boolean tells(Change one, AnswerTable right) {
        return switch (one) {
            case TRUE_FOR_FALSE, ALWAYS_TRUE ->
                    right.values().filter(Boolean.FALSE::equals).count() >= 2;
            case FIRST_LEFT_OUT, LAST_LEFT_OUT, FIRST_AGAIN_AT_THE_END, EACH_TWICE ->
                    right.rows().count() >= ENOUGH;
            default -> right.numbers().count() == 0 || right.magnitudes() >= 2;
        };
    }

    private static Stream<Cause> scaled(AnswerTable right, AnswerTable actual) {
        return FACTORS.keySet().stream()
                .filter(name -> scaled(right, name).isSameAs(actual))
                .map(name -> new Cause(SCALED + name, Message.of("known-scaled", name)));
    }

    private static AnswerTable scaled(AnswerTable right, String factor) {
        double by = FACTORS.get(factor);
        return right.withValues(one -> one instanceof Double a ? a * by : one);
    }

    /** Whether no number has more digits than a float, though the right ones have. */
    private static boolean isInFloat(AnswerTable right, AnswerTable actual) {
        return actual.isSameAs(right, FLOAT)
                && actual.magnitudes() >= 2
                && actual.allNumbers(KnownChanges::isFloat)
                && !right.allNumbers(KnownChanges::isFloat);
    }

    private static boolean isFloat(double one) {
        return Double.compare(one, (float) one) == 0;
    }

    /** Whether numbers above 1 stand where 1 is right, and all else is right. */
    private static boolean isNotCut(AnswerTable right, AnswerTable actual) {
        DoubleStream numbers = actual.numbers();
        return numbers.anyMatch(one -> one > 1)
                && actual.withValues(one -> one instanceof Double a ? Math.min(1, a) : one)
                        .isSameAs(right);
    }
}
