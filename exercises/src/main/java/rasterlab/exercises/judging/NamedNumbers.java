package rasterlab.exercises.judging;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.score.Phrase;

/**
 * Whole numbers that are drawn anew for each input and stand in its {@link Template} by their
 * names: {@code "0..along"} draws one of that range, {@code "=2*half"} computes one. Those before
 * it may be used by each. A sum has terms with {@code +} and {@code -} between them; a term has
 * names and numbers, multiplied by {@code *} and divided by {@code %}, which leaves the rest.
 */
final class NamedNumbers {
    private static final Pattern NAME = Pattern.compile("[a-z][a-zA-Z]*");
    private static final String FACTOR = "(?:[a-z][a-zA-Z]*|\\d{1,10})";
    private static final String TERM = FACTOR + "(?:[*%]" + FACTOR + ")*";
    private static final Pattern SUM = Pattern.compile("-?" + TERM + "(?:[-+]" + TERM + ")*");
    private static final Pattern SIGNED = Pattern.compile("([-+]?)(" + TERM + ")");

    private final Phrase place;
    private final Map<String, String> texts = new LinkedHashMap<>();
    private final Map<String, Sum> sums = new HashMap<>();

    /** A sum that is read once and computed for each input. */
    private interface Sum {
        long of(Map<String, Long> known);
    }

    /**
     * @throws CatalogueException if a name is none
     */
    NamedNumbers(Phrase place, JsonNode let) {
        this.place = place;
        let.properties()
                .forEach(
                        one -> {
                            if (!NAME.matcher(one.getKey()).matches())
                                throw wrong("template.name", one.getKey());
                            texts.put(one.getKey(), one.getValue().asText());
                        });
    }

    /**
     * New ones.
     *
     * @throws CatalogueException if a text is no range or sum of such numbers
     */
    Map<String, Long> draw(Random random) {
        Map<String, Long> numbers = new HashMap<>();
        texts.forEach((name, text) -> numbers.put(name, number(text, numbers, random)));
        return numbers;
    }

    private long number(String text, Map<String, Long> known, Random random) {
        if (text.startsWith("=")) return sum(text.substring(1), known);
        int dots = text.indexOf("..");
        if (dots < 0) return sum(text, known);
        long least = sum(text.substring(0, dots), known);
        long count = sum(text.substring(dots + 2), known) - least + 1;
        if (count < 1 || count > Integer.MAX_VALUE) throw wrong("template.range", text);
        return least + random.nextInt((int) count);
    }

    /**
     * The value of a sum.
     *
     * @throws CatalogueException if it is none, or has a name that is not known
     */
    long sum(String text, Map<String, Long> known) {
        try {
            return sums.computeIfAbsent(text, this::read).of(known);
        } catch (ArithmeticException beyond) {
            throw wrong("template.sum", text);
        }
    }

    private Sum read(String text) {
        if (!SUM.matcher(text).matches()) throw wrong("template.sum", text);
        Matcher each = SIGNED.matcher(text);
        Sum sum = known -> 0;
        while (each.find()) {
            Sum before = sum;
            Sum term = product(each.group(2));
            sum =
                    each.group(1).equals("-")
                            ? known -> Math.subtractExact(before.of(known), term.of(known))
                            : known -> Math.addExact(before.of(known), term.of(known));
        }
        return sum;
    }

    private Sum product(String term) {
        String[] factors = term.split("[*%]");
        Sum product = factor(factors[0]);
        int at = factors[0].length();
        for (int i = 1; i < factors.length; i++) {
            Sum before = product;
            Sum next = factor(factors[i]);
            product =
                    term.charAt(at) == '*'
                            ? known -> Math.multiplyExact(before.of(known), next.of(known))
                            : known -> Math.floorMod(before.of(known), next.of(known));
            at += 1 + factors[i].length();
        }
        return product;
    }

    private Sum factor(String text) {
        if (Character.isDigit(text.charAt(0))) {
            long number = Long.parseLong(text);
            return known -> number;
        }
        return known -> {
            Long value = known.get(text);
            if (value == null)
                throw wrong("template.unknown", text, String.join(", ", texts.keySet()));
            return value;
        };
    }

    private CatalogueException wrong(String key, Object... arguments) {
        return new CatalogueException(Phrase.of("field.wrong", place, Phrase.of(key, arguments)));
    }
}
