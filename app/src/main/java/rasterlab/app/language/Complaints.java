package rasterlab.app.language;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What readers and writers of files say in English, in the window's language: the sentences, and in
 * each the numbers.
 *
 * <p>A sentence is found by the English pattern that it fits, the one with most words of its own
 * first; what stands in its places is translated likewise. A sentence that fits none, such as one
 * of the operating system, stays as it is.
 */
public final class Complaints {
    private static final Pattern PLACE = Pattern.compile("\\{(\\d)}");

    /** Compiled once: they are also asked for while a picture is painted. */
    private static final List<Sentence> SENTENCES = sentences();

    private final Texts translations;
    private final Language language;

    /**
     * @param pattern with a group for each place, in the order of {@code places}
     * @param ownLength letters outside the places
     */
    private record Sentence(String key, Pattern pattern, List<Integer> places, int ownLength) {
        static Sentence of(String key, String english) {
            var pattern = new StringBuilder();
            var places = new ArrayList<Integer>();
            Matcher place = PLACE.matcher(english);
            int end = 0;
            int own = english.length();
            while (place.find()) {
                pattern.append(Pattern.quote(english.substring(end, place.start())))
                        .append("(.+?)");
                places.add(Integer.parseInt(place.group(1)));
                end = place.end();
                own -= place.group().length();
            }
            pattern.append(Pattern.quote(english.substring(end)));
            return new Sentence(
                    key, Pattern.compile(pattern.toString(), Pattern.DOTALL), places, own);
        }
    }

    private Complaints(Language language) {
        translations = Texts.of("language", "complaints", language);
        this.language = language;
    }

    private static List<Sentence> sentences() {
        Texts english = Texts.of("language", "complaints", Language.ENGLISH);
        return english.keys().stream()
                .map(key -> Sentence.of(key, english.text(key)))
                .sorted(
                        Comparator.comparingInt(Sentence::ownLength)
                                .reversed()
                                .thenComparing(Sentence::key))
                .toList();
    }

    /** The sentence in that language. */
    public static String said(Language language, String english) {
        return new Complaints(language).said(english).orElse(english);
    }

    private Optional<String> said(String english) {
        for (Sentence sentence : SENTENCES) {
            Matcher found = sentence.pattern.matcher(english);
            if (found.matches()) return Optional.of(said(sentence, found));
        }
        return Optional.empty();
    }

    private String said(Sentence sentence, Matcher found) {
        String text = translations.text(sentence.key);
        return PLACE.matcher(text)
                .replaceAll(
                        place -> {
                            int number = Integer.parseInt(place.group(1));
                            String value = found.group(sentence.places.indexOf(number) + 1);
                            String own = NumberForm.of(value, language);
                            return Matcher.quoteReplacement(said(value).orElse(own));
                        });
    }
}
