package rasterlab.exercises.searching;

import java.util.Random;

/** Numbers at which angles, grey levels and percentages come to an end or turn over. */
final class RoundNumbers {
    private static final double[] NUMBERS = {
        30, 45, 60, 90, 180, 270, 360, 100, 127, 128, 255, 256
    };

    private RoundNumbers() {}

    /** One of them, of either sign. */
    static double any(Random random) {
        double number = NUMBERS[random.nextInt(NUMBERS.length)];
        return random.nextInt(4) == 0 ? -number : number;
    }
}
