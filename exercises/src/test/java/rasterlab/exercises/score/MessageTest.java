package rasterlab.exercises.score;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A report's sentences survive storing and are there in both languages. */
class MessageTest {
    private static final Pattern PLACE = Pattern.compile("\\{(\\d+)}");

    /**
     * The keys whose first place is that of an English text, their second that of a Russian one.
     */
    private static final Set<String> TITLED =
            Set.of(
                    "printed.case",
                    "why.asked",
                    "group.hidden",
                    "in-both-languages",
                    "predict.why",
                    "compared.steps.unit");

    /** Sentences that only hold other ones. */
    private static final Set<String> SAME =
            Set.of(
                    "minus",
                    "join.list",
                    "join.example",
                    "join.end",
                    "quoted",
                    "engine",
                    "answer.engine",
                    "rows",
                    "folder.at");

    private static final Message TWO =
            Message.of("pixel.missing", "(1, 2)").and(Message.of("known-fault", "naive"));

    @Test
    void joinsItsSentencesInTheLanguageAskedFor() {
        assertEquals("pixel (1, 2) is missing; naive draws the same", TWO.in("en"));
        assertEquals("нет пикселя (1; 2); так же рисует naive", TWO.in("ru"));
        assertEquals(TWO.in("en"), TWO.in("de"), "no such language");
    }

    @Test
    @DisplayName("a minus is a hyphen for people, or what programs read in English changes")
    void writesCoordinatesInTheLanguageAskedFor() {
        Message extra = Message.of("pixel.extra", "(-3, -40)");
        assertTrue(extra.in("en").contains("(−3, −40)"), extra.in("en"));
        assertTrue(extra.inJson("en").contains("(-3, -40)"), extra.inJson("en"));
        assertTrue(extra.in("ru").contains("(−3; −40)"), extra.in("ru"));
        Message part = Message.of("picture.part", -5, -1, -9, 0, 0, 1, 0, 1);
        assertTrue(part.in("ru").contains("−5..−1"), part.in("ru"));
    }

    @Test
    @DisplayName("a Russian number has a decimal point, or a student's text changes")
    void writesFractionsInTheLanguageAskedFor() {
        Message late = Message.of("child.time", 2.5);
        assertTrue(late.in("en").contains("2.5"), late.in("en"));
        assertTrue(late.in("ru").contains("2,5"), late.in("ru"));
        assertEquals("2.5", Message.quoted("2.5").in("ru"));
        Message printed = Message.of("printed", "x", "(-3, -4)");
        assertTrue(printed.in("ru").contains("(-3, -4)"), printed.in("ru"));
        Phrase typed = Phrase.of("field.only", 2, "0.5");
        assertTrue(typed.in("ru").contains("0.5"), typed.in("ru"));
    }

    @Test
    @DisplayName("a point or a power of ten keeps its English signs in Russian")
    void writesPointsAndPowersInTheLanguageAskedFor() {
        Message row = Message.of("drawing.table.row", 0, "(-0.5, 1.5·10⁻⁷, NaN, -∞)");
        assertEquals("row 0: (−0.5, 1.5·10⁻⁷, NaN, −∞)", row.in("en"));
        assertEquals("строка 0: (−0,5; 1,5·10⁻⁷; NaN; −∞)", row.in("ru"));
    }

    @ParameterizedTest(
            name =
                    "a step''s value keeps its English signs in Russian, or a text loses its own: {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "x = 3, y = -0.5 | x = 3; y = −0,5",
                "corner = (0.5, 2) | corner = (0,5; 2)",
                "points = ((1, 2.5), (-3, 4)), t = 1.5·10¹² | points = ((1; 2,5); (−3; 4)); t = 1,5·10¹²",
                "6.12·10⁻¹⁷ | 6,12·10⁻¹⁷",
                "(0.5, -6.12·10⁻¹⁷) | (0,5; −6,12·10⁻¹⁷)",
                "verdict = left-half | verdict = left-half",
                "the sum of both, at 1.5 | the sum of both, at 1.5"
            })
    void writesValuesOfStepsInTheLanguageAskedFor(String english, String russian) {
        assertEquals("ваш ответ " + russian + ", он верен", right(english, "ru"));
        String signed = english.replaceAll("-(?=\\d)", "−");
        assertEquals("you answered " + signed + ", which is right", right(english, "en"));
    }

    @Test
    void writesPowersOfTenOfEarlierReportsAsItsOwn() {
        assertEquals(
                "ваш ответ (−6,12·10⁻¹⁷; 1,5·10¹²), он верен", right("(-6.12E-17, 1.5E+12)", "ru"));
        assertEquals("you answered 6.12·10⁻¹⁷, which is right", right("6.12E-17", "en"));
    }

    private static String right(String value, String language) {
        return Message.of("predict.right", value).in(language);
    }

    @ParameterizedTest(name = "the engine''s reason stays English within a Russian sentence: {0}")
    @ValueSource(
            strings = {
                "break.refuses",
                "break.crashes",
                "engine",
                "answer.engine",
                "answer.unusable"
            })
    void theEnginesReasonIsSaidInTheLanguageAskedFor(String key) {
        String english = "pixels × edges in their rows must be at most 1000000000, got 2000000000";
        assertTrue(Message.of(key, english).in("en").contains(english));
        String said = Message.of(key, english).in("ru");
        assertTrue(said.contains("получено 2000000000") && !said.contains("must"), said);
    }

    @ParameterizedTest(name = "a folder or field called 1.5 gets a Russian comma: {0}")
    @ValueSource(
            strings = {
                "field",
                "field.case",
                "folder.at",
                "folder.words",
                "folder.name",
                "folder.long",
                "folder.utf",
                "picture.elsewhere",
                "picture.ending",
                "picture.form",
                "json.duplicate",
                "json.expected.got",
                "internal.exercise",
                "known-fault",
                "formula.unknown",
                "creating"
            })
    void leavesNamesAsTheyAre(String key) {
        String said = Message.of(key, "1.5", "1.5").in("ru");
        assertTrue(said.contains("1.5") && !said.contains("1,5"), said);
    }

    @ParameterizedTest(name = "a measured time has a decimal point in Russian: {0}")
    @ValueSource(strings = {"speed.measured", "speed.worthless"})
    void writesMeasuredTimesInTheLanguageAskedFor(String key) {
        String said = Message.of(key, "3.1", "2.5", "1.24", "1.5", "8").in("ru");
        String times =
                "3,1\u00a0нс на пиксель, у эталона 2,5\u00a0нс, отношение 1,24; все баллы\u00a0— до 1,5";
        assertTrue(said.startsWith(times), said);
    }

    @Test
    void aPhraseWithinAPhraseIsInTheSameLanguage() {
        Phrase place = Phrase.of("field", Phrase.quoted("a.json"), "to");
        Phrase said = Phrase.of("field.wrong", place, Phrase.of("field.missing"));
        assertEquals("a.json, field 'to' is missing", said.toString());
        assertEquals("a.json, поле «to»: не хватает значения", said.in("ru"));
    }

    @Test
    void takesNothingInAStudentsTextForAPlaceToFill() {
        assertEquals("it's {0} '{1}'", Message.quoted("it's {0} '{1}'").in("ru"));
    }

    @Test
    void comesBackFromItsData() {
        assertEquals(TWO, Message.ofData(TWO.data(), ""));
        assertEquals(Message.NONE, Message.ofData(Message.NONE.data(), ""));
        Message odd = Message.quoted("\"],[\\ \u0001 \n\uD83D\uDE00");
        assertEquals(odd, Message.ofData(odd.data(), ""));
    }

    @ParameterizedTest(name = "data of another version loses its English text: {0}")
    @ValueSource(strings = {"[[\"no-such-key\"]]", "[[]]", "", "{", "[1,", "{\"a\":1}"})
    void isEnglishWhereItsDataCannotBeRead(String data) {
        assertEquals("as it was", Message.ofData(data, "as it was").in("ru"));
    }

    @ParameterizedTest(name = "a stored sentence without a text of today is in English only: {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "known-answer | ray answers the same | ray отвечает так же",
                "pixel.twice | pixel ray is plotted twice | пиксель ray нарисован дважды",
                "answer.worst.ulps | what is misjudged is up to ray ulps from the boundary | неверно оценённое отстоит от границы не больше чем на ray ulp",
                "break.none-answers | no right method takes this input, so it breaks nothing; ray says | ни один верный метод не принимает этот вход, поэтому он никого не разоблачает; метод ray сообщает:"
            })
    void aSentenceThatIsOnlyStoredIsReadInBothLanguages(
            String key, String english, String russian) {
        Message stored = Message.ofData("[[\"%s\",\"ray\"]]".formatted(key), "another");
        assertEquals(english, stored.in("en"));
        assertEquals(russian, stored.in("ru"));
        assertFalse(Message.isKnown(key), "a new report would have it");
    }

    @Test
    void aKeyWithoutATextIsOurMistake() {
        assertThrows(AssertionError.class, () -> Message.of("no-such-key"));
    }

    @ParameterizedTest
    @EnumSource
    void everyVerdictHasAHint(GradingVerdict verdict) {
        assertEquals(verdict == GradingVerdict.OK, verdict.hint().isEmpty());
    }

    @Test
    void bothLanguagesHaveTheSameKeysAndPlaces() throws IOException {
        assertEquals(places("messages.properties"), places("messages_ru.properties"));
    }

    @Test
    void aCaseIsCalledByItsTitleInTheReadersLanguage() {
        Message said = Message.of("printed.case", "single point", "одна точка", "x = 1");
        assertEquals("printed in “single point”: x = 1", said.in("en"));
        assertEquals("напечатано в тесте «одна точка»: x = 1", said.in("ru"));
    }

    @Test
    void nothingIsLeftInEnglish() throws IOException {
        Properties english = AllTexts.in("messages.properties");
        Properties russian = AllTexts.in("messages_ru.properties");
        for (String key : english.stringPropertyNames())
            if (!SAME.contains(key))
                assertNotEquals(english.getProperty(key), russian.getProperty(key), key);
    }

    @Test
    void noTextShowsAPlaceUnfilled() throws IOException {
        for (String name : new String[] {"en", "ru"})
            for (String key : AllTexts.in("messages.properties").stringPropertyNames()) {
                String said = Message.of(key, "A", "B", "C", "D", "E", "F", "G", "H").in(name);
                assertFalse(PLACE.matcher(said).find() || said.contains("''"), said);
            }
    }

    @ParameterizedTest(name = "one of a kind is told as several: {0}")
    @CsvSource({
        "1, the array has 1 input; 1 to 3 can be submitted",
        "0, the array has 0 inputs; 1 to 3 can be submitted",
        "21, the array has 21 inputs; 1 to 3 can be submitted"
    })
    void aCountHasTheFormThatGoesWithIt(int count, String said) {
        assertEquals(said, Message.of("break.count", count, 3).in("en"));
    }

    @ParameterizedTest(name = "a Russian count has the wrong form: {0}")
    @CsvSource({"1, и ещё 1 ошибка", "3, и ещё 3 ошибки", "11, и ещё 11 ошибок"})
    void aRussianCountHasTheFormThatGoesWithIt(int count, String said) {
        assertEquals(said, Message.of("faults.more", count).in("ru"));
    }

    @ParameterizedTest(name = "a student reads a path of JSON: {1}")
    @CsvSource(
            delimiter = '|',
            value = {
                "clip-segment | segments[0][1] | y of the start of segment 1 is 3 | отрезок 1, y начала: 3",
                "clip-segment | segments[11][2] | x of the end of segment 12 is 3 | отрезок 12, x конца: 3",
                "point-in-triangle | inside[4] | the answer for point 5 is 3 | ответ для точки 5: 3",
                "shade-face | intensity[2][0] | the red of point 3 is 3 | точка 3, доля красного: 3",
                "matrix | matrix[2][0] | row 3, column 1 of the matrix is 3 | матрица, строка 3, столбец 1: 3",
                "color | hsv[0] | hsv[0] is 3 | hsv[0]: 3"
            })
    void aPlaceIsToldInWords(String topic, String path, String english, String russian) {
        Message said = Message.of("answer.at", path, 3, 0, topic);
        assertEquals(english + ", right is 0", said.in("en"));
        assertEquals(russian + ", верно 0", said.in("ru"));
        assertEquals(Optional.of(path), said.place());
    }

    @Test
    void aPlaceThatWasStoredWithoutItsTopicIsStillRead() {
        assertEquals(
                "inside[4] is false, right is true",
                Message.of("answer.at", "inside[4]", false, true).in("en"));
        assertEquals(Optional.empty(), Message.of("answer.null").place());
    }

    private static Map<String, TreeSet<String>> places(String file) throws IOException {
        Map<String, TreeSet<String>> places = new TreeMap<>();
        AllTexts.in(file)
                .forEach(
                        (key, text) -> {
                            TreeSet<String> found = new TreeSet<>();
                            PLACE.matcher((String) text)
                                    .results()
                                    .forEach(one -> found.add(one.group(1)));
                            if (!TITLED.contains(key)) places.put((String) key, found);
                        });
        return places;
    }
}
