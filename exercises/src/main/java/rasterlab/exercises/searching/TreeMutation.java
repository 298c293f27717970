package rasterlab.exercises.searching;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.BooleanNode;
import com.fasterxml.jackson.databind.node.TextNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import rasterlab.engine.border.BorderNumbers;
import rasterlab.exercises.searching.TreeParts.TreePlace;

/**
 * Changes an input in one place, towards what methods stumble over: border numbers, equal and
 * neighbouring ones, coincident and collinear points, items too many, too few or none.
 */
final class TreeMutation {
    private final Random random;

    TreeMutation(Random random) {
        this.random = random;
    }

    /** This input with one to four changes. */
    JsonNode changed(JsonNode tree) {
        JsonNode copy = tree.deepCopy();
        int changes = 1 + random.nextInt(4);
        for (int i = 0; i < changes; i++) change(copy);
        return copy;
    }

    private void change(JsonNode tree) {
        var parts = new TreeParts(tree);
        switch (random.nextInt(10)) {
            case 0, 1, 2, 3 -> changeLeaf(parts);
            case 4 -> spread(parts);
            case 5, 6 -> changeItems(parts);
            case 7 -> alignItem(parts);
            case 8 -> scale(parts, tree);
            default -> equate(parts);
        }
    }

    private <T> T any(List<T> all) {
        return all.get(random.nextInt(all.size()));
    }

    private void changeLeaf(TreeParts parts) {
        if (parts.leaves().isEmpty()) return;
        TreePlace leaf = any(parts.leaves());
        JsonNode value = leaf.value();
        if (value.isNumber()) leaf.put(TreeParts.number(finite(number(value, parts))));
        else if (value.isBoolean()) leaf.put(BooleanNode.valueOf(!value.booleanValue()));
        else if (value.isTextual()) leaf.put(TextNode.valueOf(text(value.textValue(), parts)));
    }

    private double number(JsonNode value, TreeParts parts) {
        double old = value.doubleValue();
        return switch (random.nextInt(12)) {
            case 0 -> Math.nextUp(old);
            case 1 -> Math.nextDown(old);
            case 2 -> -old;
            case 3 -> BorderNumbers.border(random);
            case 4 -> BorderNumbers.anywhere(random);
            case 5 -> BorderNumbers.ordinary(random);
            case 6 -> BorderNumbers.whole(random);
            case 9 -> RoundNumbers.any(random);
            case 7 -> Math.rint(old) + random.nextInt(3) - 1;
            case 8 -> old + (random.nextBoolean() ? 1 : -1) * Math.scalb(1.0, -random.nextInt(30));
            default -> BorderNumbers.related(random, values(parts));
        };
    }

    private static List<Double> values(TreeParts parts) {
        return parts.numbers().stream().map(place -> place.value().doubleValue()).toList();
    }

    private static double finite(double number) {
        return Double.isFinite(number) ? number : 0;
    }

    /** A character of the text becomes another one of any text. */
    private String text(String old, TreeParts parts) {
        if (old.isEmpty()) return old;
        List<TreePlace> texts =
                parts.leaves().stream().filter(place -> place.value().isTextual()).toList();
        String other = any(texts).value().textValue();
        if (other.isEmpty()) return old;
        var changed = new StringBuilder(old);
        changed.setCharAt(
                random.nextInt(old.length()), other.charAt(random.nextInt(other.length())));
        return changed.toString();
    }

    /** One number stands in place of all that are equal to it. */
    private void spread(TreeParts parts) {
        List<TreePlace> numbers = parts.numbers();
        if (numbers.isEmpty()) return;
        double old = any(numbers).value().doubleValue();
        JsonNode other = any(numbers).value();
        for (TreePlace place : numbers) if (place.value().doubleValue() == old) place.put(other);
    }

    /** One number is set to another. */
    private void equate(TreeParts parts) {
        List<TreePlace> numbers = parts.numbers();
        if (!numbers.isEmpty()) any(numbers).put(any(numbers).value());
    }

    private void changeItems(TreeParts parts) {
        List<ArrayNode> filled = parts.arrays().stream().filter(each -> !each.isEmpty()).toList();
        if (filled.isEmpty()) return;
        ArrayNode array = any(filled);
        int one = random.nextInt(array.size());
        int other = random.nextInt(array.size());
        switch (random.nextInt(6)) {
            case 0 -> array.remove(one);
            case 1 -> array.insert(other, array.get(one).deepCopy());
            case 2 -> array.set(other, array.get(one).deepCopy());
            case 3 -> {
                JsonNode moved = array.remove(one);
                array.insert(random.nextInt(array.size() + 1), moved);
            }
            case 4 -> {
                while (array.size() > one) array.remove(array.size() - 1);
            }
            default -> {
                JsonNode swapped = array.get(one);
                array.set(one, array.get(other));
                array.set(other, swapped);
            }
        }
    }

    /** A point comes onto the line through two others. */
    private void alignItem(TreeParts parts) {
        List<ArrayNode> lists =
                parts.arrays().stream()
                        .filter(each -> each.size() > 2 && each.get(0) instanceof ArrayNode)
                        .toList();
        if (lists.isEmpty()) return;
        ArrayNode list = any(lists);
        if (!(list.get(random.nextInt(list.size())) instanceof ArrayNode moved)
                || !(list.get(random.nextInt(list.size())) instanceof ArrayNode a)
                || !(list.get(random.nextInt(list.size())) instanceof ArrayNode b)) return;
        double along = new double[] {0.5, 2, -1, 0.1, 1.0 / 3}[random.nextInt(5)];
        for (int i = 0; i < Math.min(moved.size(), Math.min(a.size(), b.size())); i++) {
            double from = a.get(i).doubleValue();
            double at = from + along * (b.get(i).doubleValue() - from);
            if (moved.get(i).isNumber()) moved.set(i, TreeParts.number(finite(at)));
        }
    }

    /** All numbers of one field, or of the whole input, become larger, smaller or farther out. */
    private void scale(TreeParts parts, JsonNode tree) {
        List<TreePlace> numbers = random.nextBoolean() ? parts.numbers() : ofOneField(tree);
        boolean toTheBorder = random.nextInt(3) == 0;
        double factor =
                toTheBorder ? toTheBorder(numbers) : Math.scalb(1.0, random.nextInt(121) - 60);
        boolean added = !toTheBorder && random.nextBoolean();
        for (TreePlace place : numbers) {
            double old = place.value().doubleValue();
            place.put(TreeParts.number(finite(added ? old + factor : old * factor)));
        }
    }

    private List<TreePlace> ofOneField(JsonNode tree) {
        List<JsonNode> fields = new ArrayList<>();
        for (JsonNode field : tree) if (field.isContainerNode()) fields.add(field);
        return fields.isEmpty() ? List.of() : new TreeParts(any(fields)).numbers();
    }

    /** The factor by which the largest of the numbers has a square that overflows or vanishes. */
    private double toTheBorder(List<TreePlace> numbers) {
        double most =
                numbers.stream()
                        .mapToDouble(n -> Math.abs(n.value().doubleValue()))
                        .max()
                        .orElse(0);
        if (most == 0) return 1;
        int exponent = 513 + random.nextInt(500);
        return Math.scalb(
                1.0, (random.nextBoolean() ? exponent : -exponent) - Math.getExponent(most));
    }
}
