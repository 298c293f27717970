package rasterlab.exercises.score;

import com.fasterxml.jackson.core.JsonProcessingException;
import java.text.DecimalFormatSymbols;
import java.text.MessageFormat;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import rasterlab.exercises.complaint.ComplaintTexts;
import rasterlab.exercises.document.OwnJson;
import rasterlab.exercises.words.PluralForms;

/**
 * A sentence of a report to a student, as data: it is put into words of a language only where
 * somebody reads it. The words stand in {@code messages.properties} beside this class.
 */
public record Message(List<Sentence> sentences) {
    public static final Message NONE = new Message(List.of());

    private static final String ROWS = "rows";

    /** A number of items above what a picture of pixels has in its rows. */
    private static final int MOST_IN_ROWS = 10_000;

    /** A number as this project writes it: 12, -0.5, 1.5·10³⁰⁰, ∞, NaN. */
    private static final String NUMBER = "(-?\\d+(\\.\\d+)?(·10⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)?|-?∞|NaN)";

    private static final Pattern ALONE = Pattern.compile(NUMBER);

    /** A pixel, a point, or another row of numbers. */
    private static final String ROW = "\\(" + NUMBER + "(, " + NUMBER + ")*\\)";

    /** One such row or several. */
    private static final Pattern IN_BRACKETS = Pattern.compile(ROW + "( " + ROW + ")*");

    /**
     * The texts whose places hold numbers and pixels of ours. In all others a number may be a name
     * or stand in somebody's file or program, and stays as it is.
     */
    private static final Pattern NUMBERS =
            Pattern.compile(
                    "pixel\\..*|line\\.example|mistake\\.shifted|picture\\.part|child\\.time.*|not-run\\.time|complex\\.time|formula\\.large|speed\\..*|property\\.areas|answer\\.(?:at.*|worst.*)|drawing\\..*|decided\\..*|compared\\.(?:within|steps.*)");

    /** The texts whose places hold values of steps. */
    private static final Pattern STEPS = Pattern.compile("predict\\.(?:right|wrong|open|why)");

    /** The texts whose places hold what the engine says in English. */
    private static final Set<String> OF_THE_ENGINE =
            Set.of(
                    "engine",
                    "answer.engine",
                    "answer.unusable",
                    "break.refuses",
                    "refusal.wanted",
                    "break.all-refuse",
                    "break.crashes",
                    "timed.refused");

    /** The texts whose places may hold keys of others, on mistakes or a property. */
    private static final Set<String> WITHIN =
            Set.of(
                    "known-mistake",
                    "known-fault.told",
                    "compared.within",
                    "known-answer.told",
                    "case.break.method",
                    "why.hazard",
                    "why.property",
                    "why.mistake",
                    "why.mistakes",
                    "property.broken",
                    "property.held",
                    "property.assumes");

    /** The beginning of the keys of texts on a place in an answer, which stands first in them. */
    private static final String AT = "answer.at";

    /**
     * @param key of the text
     * @param arguments what stands in its places {0}, {1}, …; made visible
     */
    public record Sentence(String key, List<String> arguments) {
        public Sentence {
            int most = key.equals(ROWS) ? MOST_IN_ROWS : VisibleText.MOST;
            arguments = arguments.stream().map(one -> VisibleText.lines(one, most)).toList();
        }

        /**
         * @param signs the key of the minus that stands in its numbers
         */
        private String in(ReportTexts texts, String signs) {
            Object[] said =
                    arguments.stream()
                            .map(one -> argumentText(one, texts, texts.text(signs)))
                            .toArray();
            place().ifPresent(
                            path ->
                                    said[0] =
                                            AnswerPlace.in(
                                                    texts, arguments.get(said.length - 1), path));
            String pattern =
                    PluralForms.chosen(texts.text(key), arguments.toArray(), texts.locale());
            return new MessageFormat(pattern, Locale.ROOT).format(said);
        }

        /**
         * A number or numbers in brackets with a minus and the language's decimal sign, and with
         * what it sets between numbers; what the engine says in the language of people, and as it
         * is for programs; all else as it is.
         */
        private String argumentText(String argument, ReportTexts texts, String minus) {
            if (WITHIN.contains(key) && texts.has(argument)) return texts.text(argument);
            boolean isForPrograms = minus.equals("-");
            if (OF_THE_ENGINE.contains(key) && !isForPrograms)
                return ComplaintTexts.translated(language(texts), argument);
            if (STEPS.matcher(key).matches())
                return StepWords.in(texts.locale())
                        .word(StepValue.in(argument, minus, point(texts), texts.text("apart")));
            return NUMBERS.matcher(key).matches() ? inForm(argument, texts, minus) : argument;
        }

        /** The place in an answer that is told, as a path of its JSON. */
        private Optional<String> place() {
            return key.startsWith(AT) && arguments.size() > 1
                    ? Optional.of(arguments.get(0))
                    : Optional.empty();
        }

        private static String inForm(String argument, ReportTexts texts, String minus) {
            if (!ALONE.matcher(argument).matches() && !IN_BRACKETS.matcher(argument).matches())
                return argument;
            return argument.replace("-", minus)
                    .replace('.', point(texts))
                    .replace(", ", texts.text("apart"));
        }

        private static Locale language(ReportTexts texts) {
            Locale known = texts.locale();
            return known.getLanguage().isEmpty() ? Locale.ENGLISH : known;
        }

        private static char point(ReportTexts texts) {
            return DecimalFormatSymbols.getInstance(texts.locale()).getDecimalSeparator();
        }
    }

    public Message {
        sentences = List.copyOf(sentences);
    }

    /** Whether there is a text of that key. */
    public static boolean isKnown(String key) {
        return ReportTexts.in("en").has(key);
    }

    /** One sentence of ours. */
    public static Message of(String key, Object... arguments) {
        if (!ReportTexts.in("en").has(key)) throw new AssertionError("no text for '" + key + "'");
        return new Message(
                List.of(new Sentence(key, Stream.of(arguments).map(String::valueOf).toList())));
    }

    /** The words of somebody else, in the language they are in; empty where the text is. */
    public static Message quoted(String text) {
        return text.isEmpty() ? NONE : of("quoted", text);
    }

    /** Rows of characters, one for each pixel of a picture: in no language. */
    public static Message rows(String rows) {
        return of(ROWS, rows);
    }

    public Message and(Message more) {
        return new Message(Stream.of(sentences, more.sentences).flatMap(List::stream).toList());
    }

    public boolean isEmpty() {
        return sentences.isEmpty();
    }

    /**
     * The message in words; English where there are none in that language.
     *
     * @param language such as "ru"
     */
    public String in(String language) {
        return in(language, "minus");
    }

    /**
     * The message as JSON has it, which programs read too: in English a minus is a hyphen.
     *
     * @param language such as "ru"
     */
    public String inJson(String language) {
        return in(language, "minus.json");
    }

    private String in(String language, String signs) {
        ReportTexts texts = ReportTexts.in(language);
        StringBuilder text = new StringBuilder();
        Joints joints = new Joints(sentences.stream().map(Sentence::key).toList());
        for (int i = 0; i < sentences.size(); i++) {
            joints.before(i).map(texts::text).ifPresent(text::append);
            text.append(sentences.get(i).in(texts, signs));
        }
        joints.end().map(texts::text).ifPresent(text::append);
        return text.toString();
    }

    /** The message as JSON to be stored: for each sentence an array of its key and arguments. */
    public String data() {
        List<List<String>> all = new ArrayList<>();
        for (Sentence one : sentences)
            all.add(Stream.concat(Stream.of(one.key()), one.arguments().stream()).toList());
        try {
            return OwnJson.MAPPER.writeValueAsString(all);
        } catch (JsonProcessingException e) {
            throw new AssertionError("texts can always be written", e);
        }
    }

    /**
     * Reads back the text that {@link #data} wrote.
     *
     * @param english taken instead where another version wrote it, with texts that are not here
     */
    public static Message ofData(String data, String english) {
        List<Sentence> sentences = new ArrayList<>();
        try {
            for (String[] one : OwnJson.MAPPER.readValue(data, String[][].class)) {
                if (one.length == 0 || !ReportTexts.in("en").had(one[0])) return quoted(english);
                sentences.add(new Sentence(one[0], List.of(one).subList(1, one.length)));
            }
            return new Message(sentences);
        } catch (JsonProcessingException e) {
            return quoted(english);
        }
    }

    /** The place in an answer that is told, such as {@code segments[0][1]}, if one is. */
    public Optional<String> place() {
        return sentences.stream().flatMap(one -> one.place().stream()).findFirst();
    }

    /** The message in English, as JSON has it. */
    @Override
    public String toString() {
        return inJson("en");
    }
}
