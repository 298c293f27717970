package rasterlab.tests.rules;

import com.fasterxml.jackson.annotation.JsonIgnore;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;

/**
 * The terms of everything that people read, one in each language for each thing, and what must not
 * be written in their place; read from {@code glossary.json}.
 *
 * @param terms the terms
 * @param phrases what must not stand in a text of either language, for another reason
 */
record Glossary(List<Term> terms, List<Phrase> phrases) {
    private static final int ANY_CASE = Pattern.CASE_INSENSITIVE | Pattern.UNICODE_CASE;

    /**
     * A thing and its names.
     *
     * @param en its English name, as it stands in texts
     * @param ru its Russian name, in the nominative
     * @param notEn other English names that it must not have
     * @param notRu other Russian names that it must not have
     * @param why why the other names are wrong; null where the right one is reason enough
     */
    record Term(String en, String ru, List<Phrase> notEn, List<Phrase> notRu, String why) {
        Term {
            notEn = notEn == null ? List.of() : List.copyOf(notEn);
            notRu = notRu == null ? List.of() : List.copyOf(notRu);
        }

        @JsonIgnore
        Pattern english() {
            return Pattern.compile(Pattern.quote(en).replace(" ", "\\E[\\s-]\\Q"), ANY_CASE);
        }

        /**
         * Finds the Russian name in any case and number: a long word without its last two letters.
         */
        @JsonIgnore
        Pattern russian() {
            var words = new ArrayList<String>();
            for (String word : ru.split(" ")) {
                String stem = word.length() > 4 ? word.substring(0, word.length() - 2) : word;
                words.add(Pattern.quote(stem) + "\\p{L}*");
            }
            return Pattern.compile(String.join("\\s+", words), ANY_CASE);
        }
    }

    /**
     * Words that must not be written.
     *
     * @param wrong a pattern of it
     * @param right what to write instead, and why; null where a term says it
     * @param caught a text that had it
     */
    record Phrase(String wrong, String right, String caught) {
        boolean in(String text) {
            return Pattern.compile(wrong, ANY_CASE).matcher(text).find();
        }
    }

    /**
     * The phrase that a rule forbids.
     *
     * @param phrase what must not be written
     * @param language {@code en}, {@code ru}, or empty for both
     * @param right what to write instead, and why
     */
    record Banned(Phrase phrase, String language, String right) {
        @Override
        public String toString() {
            return (language + " " + phrase.wrong).strip().toLowerCase(Locale.ROOT);
        }
    }

    static Glossary read() {
        try (InputStream file = Glossary.class.getResourceAsStream("glossary.json")) {
            return new ObjectMapper().readValue(file, Glossary.class);
        } catch (IOException impossible) {
            throw new AssertionError("tests/src/test/resources: glossary.json", impossible);
        }
    }

    List<Banned> banned() {
        var banned = new ArrayList<Banned>();
        for (Term term : terms) {
            String why = term.why == null ? "" : ": " + term.why;
            for (Phrase other : term.notEn) banned.add(new Banned(other, "en", term.en + why));
            for (Phrase other : term.notRu) banned.add(new Banned(other, "ru", term.ru + why));
        }
        for (Phrase phrase : phrases) banned.add(new Banned(phrase, "", phrase.right));
        return banned;
    }
}
