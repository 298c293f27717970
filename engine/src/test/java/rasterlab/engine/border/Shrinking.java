package rasterlab.engine.border;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;

/** Makes the numbers of an input that fails simpler, as long as it fails. */
final class Shrinking {
    private Shrinking() {}

    /**
     * Numbers of which none can be made simpler alone, nor two equal ones together.
     *
     * @param fails whether the input of some numbers fails
     */
    static List<Double> shrunk(List<Double> numbers, Predicate<List<Double>> fails) {
        List<Double> best = numbers;
        List<Double> next = simpler(best, fails);
        while (next != best) {
            best = next;
            next = simpler(best, fails);
        }
        return best;
    }

    /** The list itself where nothing simpler fails. */
    private static List<Double> simpler(List<Double> numbers, Predicate<List<Double>> fails) {
        for (int i = 0; i < numbers.size(); i++)
            for (double candidate : candidates(numbers.get(i))) {
                if (weight(candidate) >= weight(numbers.get(i))) continue;
                List<Double> alone = new ArrayList<>(numbers);
                alone.set(i, candidate);
                if (fails.test(alone)) return alone;
                List<Double> together = new ArrayList<>(numbers);
                together.replaceAll(equalTo(numbers.get(i), candidate));
                if (!together.equals(alone) && fails.test(together)) return together;
            }
        return numbers;
    }

    private static java.util.function.UnaryOperator<Double> equalTo(double old, double candidate) {
        return number -> number == old ? Double.valueOf(candidate) : number;
    }

    private static double[] candidates(double number) {
        double size = Math.abs(number);
        return new double[] {
            0,
            1,
            -1,
            2,
            3,
            Math.rint(number / 4),
            Math.rint(number / 2),
            number - Math.signum(number),
            size,
            Math.rint(number),
            Math.rint(number * 8) / 8,
            Math.signum(number) * Math.scalb(1.0, Math.getExponent(size)),
        };
    }

    /**
     * A measure that is least for the simplest numbers, small whole ones, and grows with what is
     * written.
     */
    private static double weight(double number) {
        boolean negative = number < 0 || 1 / number < 0;
        if (number == Math.rint(number) && Math.abs(number) < 1e6)
            return 2 * Math.abs(number) + (negative ? 1 : 0);
        return 1e7 + Double.toString(number).length();
    }
}
