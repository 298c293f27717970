package rasterlab.exercises.json;

import java.util.List;
import java.util.stream.Collectors;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.InvalidInput;
import rasterlab.exercises.score.Phrase;

/** A value that is allowed, and the refusals of any other. */
sealed interface Expected {
    /** The expectation in words, for the refusal of an input's value. */
    String words();

    /** The refusal of the value at a place of a file of people. */
    RuntimeException refused(JsonPlace<?> place);

    /** Whether it is one of several numbers that stand for one thing, such as a point. */
    default boolean inOneThing() {
        return false;
    }

    /** A number from {@code least} to {@code most}. */
    record Number(double least, double most) implements Expected {
        static final Number ANY = new Number(-Double.MAX_VALUE, Double.MAX_VALUE);

        @Override
        public String words() {
            return "a number from " + least + " to " + most;
        }

        @Override
        public RuntimeException refused(JsonPlace<?> place) {
            return place.wrong(
                    Phrase.of(
                            "field.number",
                            String.valueOf(least),
                            String.valueOf(most),
                            place.shown()));
        }
    }

    /** A number above {@code least}, up to {@code most}. */
    record NumberAbove(double least, double most) implements Expected {
        @Override
        public String words() {
            return "a number above " + least + ", up to " + most;
        }

        @Override
        public RuntimeException refused(JsonPlace<?> place) {
            double value = place.node().asDouble();
            return place.node().isNumber() && value == least
                    ? new InvalidInput("expected a number above " + least + ", got " + value)
                    : new Number(least, most).refused(place);
        }
    }

    /** A number that may be long, but not as long as that. */
    record Shorter(Expected number, int most) implements Expected {
        @Override
        public String words() {
            return number.words() + " in at most " + most + " characters";
        }

        @Override
        public RuntimeException refused(JsonPlace<?> place) {
            return number.refused(place);
        }
    }

    /** A whole number from {@code least} to {@code most}. */
    record Whole(int least, int most, boolean inOneThing) implements Expected {
        @Override
        public String words() {
            return "a whole number from " + least + " to " + most;
        }

        @Override
        public RuntimeException refused(JsonPlace<?> place) {
            return place.wrong(
                    least == most
                            ? Phrase.of("field.only", least, place.shown())
                            : Phrase.of("field.whole", least, most, place.shown()));
        }
    }

    /** True or false. */
    record Flag() implements Expected {
        @Override
        public String words() {
            return "true or false";
        }

        @Override
        public RuntimeException refused(JsonPlace<?> place) {
            return place.wrong(Phrase.of("field.flag", place.shown()));
        }
    }

    /** One of the words. */
    record Word(List<String> allowed) implements Expected {
        @Override
        public String words() {
            return "one of " + String.join(", ", allowed);
        }

        @Override
        public RuntimeException refused(JsonPlace<?> place) {
            return place.saysSomething()
                    ? place.wrong(
                            Phrase.of(
                                    "field.word",
                                    String.join(", ", allowed),
                                    place.node().textValue()))
                    : Text.none(place);
        }
    }

    /** A text, of which {@code words} tell the length. */
    record Text(String words) implements Expected {
        @Override
        public RuntimeException refused(JsonPlace<?> place) {
            return place.saysSomething() ? new InvalidInput("expected " + words) : none(place);
        }

        private static RuntimeException none(JsonPlace<?> place) {
            return place.wrong(Phrase.of("field.text", place.shown()));
        }
    }

    /**
     * An array of {@code least} to {@code most} values.
     *
     * @param what the values in words
     * @param each more words about one of them; empty where there is nothing to say
     */
    record Items(String what, String each, int least, int most) implements Expected {
        @Override
        public String words() {
            String count = least == most ? "" + least : least + " to " + most;
            return "an array of " + count + " " + what + each;
        }

        @Override
        public RuntimeException refused(JsonPlace<?> place) {
            if (!place.isArray()) return noArray(place);
            return new InvalidInput(
                    "expected an array of %d to %d %s, got %d"
                            .formatted(least, most, what, place.node().size()));
        }

        static RuntimeException noArray(JsonPlace<?> place) {
            return place.wrong(Phrase.of("field.array", place.shown()));
        }
    }

    /** An array of so many whole numbers; two are a point. */
    record Wholes(int count) implements Expected {
        @Override
        public String words() {
            return "an array of " + count + " whole numbers";
        }

        @Override
        public RuntimeException refused(JsonPlace<?> place) {
            return place.wrong(
                    count == 2
                            ? Phrase.of("field.point", place.shown())
                            : Phrase.of("field.wholes", count, place.shown()));
        }
    }

    /** An object with these fields. */
    record AnObject(List<Field<?>> fields) implements Expected {
        @Override
        public String words() {
            String required =
                    fields.stream()
                            .filter(Field::required)
                            .map(Field::name)
                            .collect(Collectors.joining(", "));
            return "a JSON object with " + (required.isEmpty() ? known() : required);
        }

        /** The names of all fields. */
        String known() {
            return fields.stream().map(Field::name).sorted().collect(Collectors.joining(", "));
        }

        @Override
        public RuntimeException refused(JsonPlace<?> place) {
            return noObject(place);
        }

        static RuntimeException noObject(JsonPlace<?> place) {
            return place.wrong(Phrase.of("field.object", place.shown()));
        }
    }
}
