package rasterlab.exercises;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import rasterlab.exercises.child.Wire;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Disclosure;

/**
 * One exercise, as its folder describes it.
 *
 * @param id lower-case with hyphens, the folder's name
 * @param topic the engine's topic whose contract the student implements
 * @param contract simple name of a smaller contract that is asked for in its place
 * @param title language code ("en", "ru") to title
 * @param statement language code to Markdown text
 * @param pictures what the statements show, by file name
 * @param starter Java source to begin with
 * @param revision changes whenever anything that grading depends on changes
 * @param tolerance what still counts as right
 * @param points the most points for accuracy, stability and speed
 * @param caps limits of a call that this exercise states itself
 * @param timed how the inputs to measure speed on are drawn, as JSON
 * @param groups what cases ask for, where several ask for the same
 * @param breaking what is handed in where the task is to break faulty methods, each of which is a
 *     case then; empty where nothing is to be broken
 * @param predicting which steps of a method are to be predicted, each of which is a case then;
 *     empty where none are
 * @param evidence what the exercise is proved by
 * @param minutes that it usually takes; empty where nobody has said
 * @param hints in steps of rising help; empty where there are none
 */
public record Exercise(
        String id,
        String topic,
        Optional<String> contract,
        Map<String, String> title,
        Map<String, String> statement,
        Map<String, StatementPicture> pictures,
        String starter,
        String revision,
        ExerciseTolerance tolerance,
        PointPlan points,
        StatedLimits caps,
        Optional<String> timed,
        List<CaseGroup> groups,
        List<Case> cases,
        Optional<Breaking> breaking,
        Optional<Predicting> predicting,
        Evidence evidence,
        OptionalInt minutes,
        List<Hint> hints) {
    /** The most points in all, and so for each kind and each case. */
    public static final int MOST_POINTS = 100;

    /** The longest that an exercise can be said to take: a working day. */
    public static final int MOST_MINUTES = 480;

    public Exercise {
        title = withEnglish("title", title);
        statement = withEnglish("statement", statement);
        pictures = Map.copyOf(pictures);
        groups = List.copyOf(groups);
        cases = List.copyOf(cases);
        hints = List.copyOf(hints);
    }

    /** An exercise each of whose cases asks for something else. */
    public Exercise(
            String id,
            String topic,
            Map<String, String> title,
            Map<String, String> statement,
            Map<String, StatementPicture> pictures,
            String starter,
            String revision,
            ExerciseTolerance tolerance,
            PointPlan points,
            List<Case> cases) {
        this(
                id,
                topic,
                title,
                statement,
                pictures,
                starter,
                revision,
                tolerance,
                points,
                StatedLimits.NONE,
                Optional.empty(),
                List.of(),
                cases,
                Optional.empty());
    }

    /** An exercise whose proof needs nothing of its own. */
    public Exercise(
            String id,
            String topic,
            Map<String, String> title,
            Map<String, String> statement,
            Map<String, StatementPicture> pictures,
            String starter,
            String revision,
            ExerciseTolerance tolerance,
            PointPlan points,
            StatedLimits caps,
            Optional<String> timed,
            List<CaseGroup> groups,
            List<Case> cases,
            Optional<Breaking> breaking) {
        this(
                id,
                topic,
                Optional.empty(),
                title,
                statement,
                pictures,
                starter,
                revision,
                tolerance,
                points,
                caps,
                timed,
                groups,
                cases,
                breaking,
                Optional.empty(),
                Evidence.NONE,
                OptionalInt.empty(),
                List.of());
    }

    /** The form of what is handed in. */
    public TaskKind form() {
        if (predicting.isPresent()) return TaskKind.PREDICT;
        return breaking.isPresent() ? TaskKind.BREAK : TaskKind.WRITE;
    }

    /** The group that a case belongs to; empty where it stands alone. */
    public Optional<CaseGroup> group(Case one) {
        return groups.stream().filter(group -> group.name().equals(one.group())).findFirst();
    }

    private static Map<String, String> withEnglish(String name, Map<String, String> texts) {
        if (!texts.containsKey("en"))
            throw new IllegalArgumentException(
                    name
                            + " needs a text in English ('en'), got only "
                            + String.join(", ", texts.keySet()));
        return Map.copyOf(texts);
    }

    private static void inRange(String name, int points) {
        if (points < 0 || points > MOST_POINTS)
            throw new IllegalArgumentException(
                    name + " must be from 0 to " + MOST_POINTS + " points, got " + points);
    }

    /** The text in that language, or the English one where there is none. */
    public String statement(String language) {
        return statement.getOrDefault(language, statement.get("en"));
    }

    /** The title in that language, or the English one where there is none. */
    public String title(String language) {
        return title.getOrDefault(language, title.get("en"));
    }

    /**
     * The title of a report's case in that language; its name where this exercise has no such case.
     *
     * @param name as in {@link CaseReport}
     */
    public String caseTitle(String name, String language) {
        return CaseReport.ownTitle(name, language)
                .or(
                        () ->
                                cases.stream()
                                        .filter(one -> one.name().equals(name))
                                        .map(one -> one.title(language))
                                        .findFirst())
                .orElse(name);
    }

    /**
     * The tolerance within which an answer counts as right.
     *
     * @param eitherPixelOnTies where the exact line passes midway between two pixels, either is
     *     right
     * @param worst the largest error that is right, in the topic's unit; where it is not given,
     *     what the topic calls correct
     * @param truth the topic's method whose answers are the right ones; where it is not given, the
     *     topic's exact answers are
     */
    public record ExerciseTolerance(
            boolean eitherPixelOnTies, OptionalDouble worst, Optional<String> truth) {
        /** The topic's own bound; either pixel of a tie where that is said. */
        public ExerciseTolerance(boolean eitherPixelOnTies) {
            this(eitherPixelOnTies, OptionalDouble.empty(), Optional.empty());
        }

        /** The topic's own bound around the same right answers. */
        public ExerciseTolerance strict() {
            return new ExerciseTolerance(false, OptionalDouble.empty(), truth);
        }
    }

    /**
     * Limits of one call that an exercise states; where it does not, the usual ones hold.
     *
     * @param items that a sink takes
     * @param bytes of the answer
     * @param processor time
     */
    public record StatedLimits(OptionalInt items, OptionalInt bytes, Optional<Duration> processor) {
        public static final StatedLimits NONE =
                new StatedLimits(OptionalInt.empty(), OptionalInt.empty(), Optional.empty());

        /** The most items that can be stated. */
        public static final int MOST_ITEMS = Wire.MOST_ITEMS - 1;

        /** The most bytes that can be stated. */
        public static final int MOST_BYTES = Wire.MOST_ANSWER_BYTES;

        /** The least processor time that a system tells apart well enough. */
        public static final double LEAST_SECONDS = 0.05;

        /** The most that can be stated: all calls together may take no more. */
        public static final double MOST_SECONDS = 8;
    }

    /**
     * Holds what an exercise is proved by; students do not see it.
     *
     * @param model source of a right program, as plain as a student writes it
     * @param notAsked faulty methods and mutants of the topic whose mistake no case asks for
     */
    public record Evidence(Optional<String> model, Set<String> notAsked) {
        static final Evidence NONE = new Evidence(Optional.empty(), Set.of());

        public Evidence {
            notAsked = Set.copyOf(notAsked);
        }
    }

    /** The most points of each kind, from 0 to 100. */
    public record PointPlan(int accuracy, int stability, int speed) {
        public PointPlan {
            inRange("accuracy", accuracy);
            inRange("stability", stability);
            inRange("speed", speed);
        }

        public int total() {
            return accuracy + stability + speed;
        }
    }

    /**
     * Cases that ask for the same.
     *
     * @param name lower-case with hyphens
     * @param title what they ask for, by language code
     * @param mistakes codes of causes that cost points here, and only here where they are found
     *     here
     */
    public record CaseGroup(String name, Map<String, String> title, Set<String> mistakes) {
        public CaseGroup {
            title = Map.copyOf(title);
            mistakes = Set.copyOf(mistakes);
        }

        /** The title in that language, or the English one; the name where there is neither. */
        public String title(String language) {
            return title.getOrDefault(language, title.getOrDefault("en", name));
        }
    }

    /**
     * One case as data; the topic's own package reads {@code input}.
     *
     * @param name what mistake it catches, lower-case with hyphens
     * @param title what it asks for, by language code; may be empty
     * @param group name of the group of cases that ask for the same; its own where it stands alone
     * @param kind whether it earns accuracy or stability
     * @param input the topic's input as JSON text; for a generated case, how to draw it from the
     *     seed
     * @param generated whether the seed draws it
     * @param property the property of the topic that is asked for; empty where the right answers
     *     are
     */
    public record Case(
            String name,
            Map<String, String> title,
            String group,
            Criterion kind,
            Disclosure visibility,
            int points,
            String input,
            boolean generated,
            Optional<String> property) {
        /** A case that stands alone. */
        public Case(
                String name,
                Map<String, String> title,
                Criterion kind,
                Disclosure visibility,
                int points,
                String input,
                boolean generated) {
            this(name, title, name, kind, visibility, points, input, generated, Optional.empty());
        }

        public Case {
            title = Map.copyOf(title);
            inRange("case '" + name + "'", points);
            if (generated && visibility == Disclosure.OPEN)
                throw new IllegalArgumentException(
                        "case '" + name + "' must not be open, since the seed draws it");
        }

        /** The title in that language, or the English one; the name where there is neither. */
        public String title(String language) {
            return title.getOrDefault(language, title.getOrDefault("en", name));
        }
    }

    /** The task of a student, which decides what is handed in. */
    public enum TaskKind {
        /** Writes a method, in Java. */
        WRITE("java", "text/x-java-source"),
        /** Finds inputs on which faulty methods fail, as JSON. */
        BREAK("json", "application/json"),
        /** Predicts the steps of a method, as JSON. */
        PREDICT("json", "application/json");

        private final String ending;
        private final String mediaType;

        TaskKind(String ending, String mediaType) {
            this.ending = ending;
            this.mediaType = mediaType;
        }

        /** How names of files that are handed in end, without the dot. */
        public String ending() {
            return ending;
        }

        /** The media type of what is handed in by HTTP. */
        public String mediaType() {
            return mediaType;
        }

        /** The media type for an exercise of that kind; inputs and steps are JSON. */
        public static String mediaType(String code) {
            return (code.equals(WRITE.code()) ? WRITE : BREAK).mediaType();
        }

        /** The word for it in data, commands and the HTTP API. */
        public String code() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    /**
     * The rules for inputs on which faulty methods fail.
     *
     * @param inputs the most that may be handed in together
     * @param sizePoints for small ones; the faulty methods share the rest
     * @param small characters of JSON without white space that earn all of them
     * @param large characters that earn none of them, more than {@code small}
     */
    public record Breaking(int inputs, int sizePoints, int small, int large) {
        /** The name of the case that pays for small inputs. */
        public static final String SIZE = "small-input";

        /** The points for inputs of so many characters, before what is left unbroken counts. */
        public double sizePoints(int characters) {
            double share = (large - characters) / (double) (large - small);
            return sizePoints * Math.max(0, Math.min(1, share));
        }
    }

    /** The points that a case earns. */
    public enum Criterion {
        ACCURACY,
        STABILITY
    }
}
