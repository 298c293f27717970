package rasterlab.exercises.complaint;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.ResourceBundle;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import rasterlab.engine.Topics;
import rasterlab.exercises.words.PluralForms;
import rasterlab.exercises.words.TopicWords;

/**
 * Translates the sentences that the engine and readers and writers of files say in English to the
 * language of the reader; the numbers in them are kept.
 *
 * <p>A sentence is found by the English pattern that it fits, the one with most words of its own
 * first; what stands in its places is translated likewise, but for what is quoted and, in a place
 * such as {@code {0,name}}, what somebody has named: a file may be called "nothing" or "1.0". A
 * number in a place such as {@code {0,about}} was computed and typed by nobody: it is rounded.
 * Where words go with a number, such as {@code {0,plural,one#value|other#values}}, either of them
 * fits, and the one of the language is said. A sentence that fits none, such as one of the
 * operating system, stays as it is.
 */
public final class ComplaintTexts {
    private static final Pattern PLACE = Pattern.compile("(['\"]?)\\{(\\d)(,name|,about)?}");

    /** Words that go with the number of a place. */
    private static final Pattern FORMS =
            Pattern.compile("\\{\\d,plural,one#([^|{}]*)\\|other#([^|{}]*)}");

    /** A place in JSON, or a file, in front of what is wrong there. */
    private static final Pattern POINTED = Pattern.compile("(/[^ :]*: )(.+)", Pattern.DOTALL);

    /** Where a topic has sentences of its own among its words. */
    private static final String OWN = "complaint.";

    /** The sentences, compiled once: they are also asked for while a picture is painted. */
    private static final List<Sentence> SENTENCES = sentences();

    private final Locale language;
    private final ResourceBundle translations;
    private final UnaryOperator<String> numbers;
    private final UnaryOperator<String> computed;

    /**
     * @param topic whose words have it; "" for those that topics share
     * @param pattern with a group for each place, in the order of {@code places}
     * @param names numbers of the places that stay as they are
     * @param computed numbers of the places whose number is rounded
     * @param pointed whether the sentence itself begins with a file and a colon
     * @param ownLength letters outside the places
     */
    private record Sentence(
            String topic,
            String key,
            Pattern pattern,
            List<Integer> places,
            Set<Integer> names,
            Set<Integer> computed,
            boolean pointed,
            int ownLength) {
        /** Whether any sentence, which is looked for behind this one, may stand in it. */
        boolean frame() {
            return key.equals("run.refuses") || key.equals("near");
        }

        static Sentence of(String topic, String key, String english) {
            var pattern = new StringBuilder();
            var places = new ArrayList<Integer>();
            var names = new HashSet<Integer>();
            var computed = new HashSet<Integer>();
            Matcher place = PLACE.matcher(english);
            int end = 0;
            int own = english.length();
            while (place.find()) {
                int number = Integer.parseInt(place.group(2));
                pattern.append(fixed(english.substring(end, place.end(1)))).append("(.+?)");
                places.add(number);
                boolean about = ",about".equals(place.group(3));
                if (about) computed.add(number);
                else if (!place.group(1).isEmpty() || place.group(3) != null) names.add(number);
                end = place.end();
                own -= end - place.end(1);
            }
            pattern.append(fixed(english.substring(end)));
            return new Sentence(
                    topic,
                    key,
                    Pattern.compile(pattern.toString(), Pattern.DOTALL),
                    places,
                    names,
                    computed,
                    english.startsWith("{0,name}: "),
                    own);
        }

        /** The text between places, with either form of words that go with a number. */
        private static String fixed(String words) {
            var pattern = new StringBuilder();
            Matcher forms = FORMS.matcher(words);
            int end = 0;
            while (forms.find()) {
                pattern.append(Pattern.quote(words.substring(end, forms.start())))
                        .append("(?:")
                        .append(Pattern.quote(forms.group(1)))
                        .append("|")
                        .append(Pattern.quote(forms.group(2)))
                        .append(")");
                end = forms.end();
            }
            return pattern.append(Pattern.quote(words.substring(end))).toString();
        }
    }

    private ComplaintTexts(
            Locale language, UnaryOperator<String> numbers, UnaryOperator<String> computed) {
        this.language = language;
        this.translations = texts(language);
        this.numbers = numbers;
        this.computed = computed;
    }

    private static List<Sentence> sentences() {
        ResourceBundle shared = texts(Locale.ENGLISH);
        return Stream.concat(
                        shared.keySet().stream()
                                .map(key -> Sentence.of("", key, shared.getString(key))),
                        Topics.names().stream().flatMap(ComplaintTexts::sentences))
                .sorted(
                        Comparator.comparing(Sentence::frame)
                                .thenComparing(Sentence::ownLength)
                                .reversed()
                                .thenComparing(Sentence::key))
                .toList();
    }

    private static Stream<Sentence> sentences(String topic) {
        ResourceBundle own = TopicWords.of(topic, Locale.ENGLISH);
        return own.keySet().stream()
                .filter(key -> key.startsWith(OWN))
                .map(key -> Sentence.of(topic, key.substring(OWN.length()), own.getString(key)));
    }

    private static ResourceBundle texts(Locale language) {
        return ResourceBundle.getBundle(
                ComplaintTexts.class.getPackageName() + ".complaints",
                language,
                ResourceBundle.Control.getNoFallbackControl(
                        ResourceBundle.Control.FORMAT_PROPERTIES));
    }

    private static boolean isEnglish(Locale language) {
        return language.getLanguage().equals("en");
    }

    /** The sentence in that language. */
    public static String translated(Locale language, String english) {
        UnaryOperator<String> numbers = number -> NumberForm.of(number, language);
        return new ComplaintTexts(language, numbers, rounded(language)).inQuotes(english);
    }

    /**
     * The sentence on a terminal: numbers keep the point that one types there, whole ones without a
     * fraction. English keeps its quotation marks and the digits of what was computed.
     */
    public static String saidToTypist(Locale language, String english) {
        UnaryOperator<String> typed = NumberForm::typed;
        return isEnglish(language)
                ? new ComplaintTexts(language, typed, typed).inSentence(english)
                : new ComplaintTexts(language, typed, rounded(language)).inQuotes(english);
    }

    /**
     * The English sentence in JSON, as it always was for programs that read it, but for Java's
     * powers of ten: 1e-8 for 1.0E-8.
     */
    public static String saidToProgram(String english) {
        return NumberForm.powers(english, NumberForm::typed);
    }

    /**
     * Whether a sentence tells why a student's program gave no answer; else it may be the program's
     * own refusal.
     */
    public static boolean isAboutProgram(String english) {
        return SENTENCES.stream()
                .filter(one -> one.topic.isEmpty() && one.key.startsWith("own."))
                .anyMatch(one -> one.pattern.matcher(english).matches());
    }

    private static UnaryOperator<String> rounded(Locale language) {
        return number -> NumberForm.rounded(number, language);
    }

    private String inQuotes(String english) {
        return Quotes.of(language, inSentence(english));
    }

    private String inSentence(String english) {
        return NumberForm.powers(translation(english).orElse(english), numbers);
    }

    private Optional<String> translation(String english) {
        for (Sentence sentence : SENTENCES) {
            Matcher found = sentence.pattern.matcher(english);
            if (found.matches())
                return sentence.pointed
                        ? Optional.of(filledIn(sentence, found))
                        : pointed(english).or(() -> Optional.of(filledIn(sentence, found)));
        }
        return Optional.empty();
    }

    /**
     * Where the place is no part of the sentence; otherwise a pattern's first place would take it.
     */
    private Optional<String> pointed(String english) {
        Matcher found = POINTED.matcher(english);
        return found.matches()
                ? translation(found.group(2)).map(said -> found.group(1) + said)
                : Optional.empty();
    }

    private String filledIn(Sentence sentence, Matcher found) {
        String text =
                sentence.topic.isEmpty()
                        ? translations.getString(sentence.key)
                        : TopicWords.of(sentence.topic, language).getString(OWN + sentence.key);
        return PLACE.matcher(chosen(text, sentence, found))
                .replaceAll(
                        place -> {
                            int number = Integer.parseInt(place.group(2));
                            String value = found.group(sentence.places.indexOf(number) + 1);
                            if (sentence.computed.contains(number)) value = computed.apply(value);
                            else if (!sentence.names.contains(number))
                                value = translation(value).orElse(numbers.apply(value));
                            return Matcher.quoteReplacement(place.group(1) + value);
                        });
    }

    /** The text with the words that go with its numbers. */
    private String chosen(String text, Sentence sentence, Matcher found) {
        Object[] values =
                new Object[sentence.places.stream().mapToInt(one -> one + 1).max().orElse(0)];
        for (int i = 0; i < sentence.places.size(); i++)
            values[sentence.places.get(i)] = found.group(i + 1);
        return PluralForms.chosen(text, values, language);
    }
}
