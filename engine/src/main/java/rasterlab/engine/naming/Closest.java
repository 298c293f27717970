package rasterlab.engine.naming;

import java.util.Collection;
import java.util.Comparator;
import java.util.Optional;

/** Finds what a mistyped word was meant to be. */
public final class Closest {
    private static final int MOST_MISTAKES = 2;

    private Closest() {}

    /**
     * The candidate that at most two typing mistakes turn into the word, if there is one; more than
     * half of the word's letters must be right.
     */
    public static Optional<String> to(String word, Collection<String> candidates) {
        return candidates.stream()
                .filter(candidate -> isNear(word, candidate))
                .min(Comparator.comparingInt(candidate -> mistakes(word, candidate)));
    }

    private static boolean isNear(String word, String candidate) {
        int mistakes = mistakes(word, candidate);
        return mistakes <= MOST_MISTAKES && 2 * mistakes < word.length();
    }

    /**
     * The least number of letters to insert, delete, change or swap with their neighbour.
     *
     * <p>Source: F. J. Damerau, Communications of the ACM 7(3), 1964; restricted to swaps that
     * nothing else touches.
     */
    private static int mistakes(String a, String b) {
        var distance = new int[a.length() + 1][b.length() + 1];
        for (int i = 0; i <= a.length(); i++)
            for (int j = 0; j <= b.length(); j++) distance[i][j] = step(a, b, i, j, distance);
        return distance[a.length()][b.length()];
    }

    private static int step(String a, String b, int i, int j, int[][] distance) {
        if (i == 0 || j == 0) return i + j;
        int change = a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1;
        int best = distance[i - 1][j - 1] + change;
        best = Math.min(best, Math.min(distance[i - 1][j], distance[i][j - 1]) + 1);
        boolean swapped =
                i > 1
                        && j > 1
                        && a.charAt(i - 1) == b.charAt(j - 2)
                        && a.charAt(i - 2) == b.charAt(j - 1);
        return swapped ? Math.min(best, distance[i - 2][j - 2] + 1) : best;
    }
}
