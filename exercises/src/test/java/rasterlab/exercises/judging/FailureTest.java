package rasterlab.exercises.judging;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.exercises.score.Answer;

/**
 * The message of an exception is English: a Russian report quotes it within a sentence of its own.
 */
class FailureTest {
    @Test
    @DisplayName("a Russian report is the exception's English alone")
    void anExceptionIsQuotedInTheReadersLanguage() {
        Answer threw = Answer.threw("java.lang.ArithmeticException", "/ by zero", 8, "");
        assertEquals(
                "java.lang.ArithmeticException: / by zero; in line 8",
                Failure.of(threw, false).message().in("en"));
        assertEquals(
                "брошено исключение «java.lang.ArithmeticException: / by zero»; в строке 8",
                Failure.of(threw, false).message().in("ru"));
    }

    @Test
    @DisplayName("a Russian report goes on in English where an answer cannot be used")
    void whatIsWrongWithAnAnswerIsQuotedInTheReadersLanguage() {
        Answer unusable =
                Answer.without(Answer.CallEnding.UNUSABLE, "", "12 shares were asked for", "");
        assertEquals(
                "возвращённое не может быть ответом; проверка сообщает: «12 shares were asked for»",
                Failure.of(unusable, false).message().in("ru"));
    }
}
