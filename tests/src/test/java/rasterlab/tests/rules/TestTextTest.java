package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TestTextTest {
    private static final TestText JAVA =
            new TestText(
                    """
                    class LineTest {
                        private static final List<Use> USES =
                                List.of(new Use("gc", "d"));

                        @Test
                        void ends() {}

                        @ParameterizedTest(name = "{argumentSetName}, past the check")
                        @MethodSource({"exits", "uses"})
                        void isRefused(String source) {}

                        static Stream<Arguments> exits() {
                            return Stream.of(argumentSet("exit", "a"), halt());
                        }

                        private static Arguments halt() {
                            return argumentSet("halt", "b");
                        }

                        static Stream<Arguments> uses() {
                            return USES.stream().map(Use::asArguments);
                        }

                        static Stream<Arguments> dropped() {
                            return Stream.of(argumentSet("old", "c"));
                        }

                        @ParameterizedTest(name = "{0} h later it takes {1} ms")
                        @CsvSource({"-1, 5", "noon, 6"})
                        void isFast(String hours, int millis) {}
                    }
                    """);

    private static final TestText KOTLIN =
            new TestText(
                    """
                    class DotTest {
                        @ParameterizedTest(name = "a student is called \\"{0}\\"")
                        @ValueSource(strings = ["%"])
                        fun aNameIsAValue(name: String) = open { join(name) }

                        @ParameterizedTest(name = "{argumentSetName}")
                        @MethodSource("requests")
                        fun answers(status: Int) = open { ask(status) }

                        companion object {
                            private suspend fun Visit.upload() = send("{}")

                            @JvmStatic
                            fun requests(): List<Arguments> = names() + asked("a path", 404)

                            private fun names() =
                                listOf(
                                    asked("a name", 422) { upload() },
                                )
                        }
                    }
                    """);

    @Test
    @DisplayName("a test with cases passes for one without, or the other way round")
    void testsHaveCasesOrNone() {
        assertTrue(JAVA.hasTest("ends") && !JAVA.hasCases("ends"));
        assertTrue(JAVA.hasCases("isRefused") && !JAVA.hasTest("isRefused"));
        assertTrue(KOTLIN.hasCases("answers") && !KOTLIN.hasTest("names"));
    }

    @ParameterizedTest(name = "{0} with the case {1} is taken to be there, or not: {2}")
    @CsvSource(
            delimiter = '|',
            value = {
                "isRefused | exit, past the check | true",
                "isRefused | halt, past the check | true",
                "isRefused | gc, past the check | true",
                "isRefused | exit | false",
                "isRefused | old, past the check | false",
                "isRefused | ex, past the check | false",
                "isFast | -1 h later it takes 5 ms | true",
                "isFast | noon h later it takes 6 ms | true",
                "isFast | 1 h later it takes 5 ms | false",
                "ends | exit | false",
                "aNameIsAValue | a student is called \"%\" | true",
                "aNameIsAValue | a student is called \"_\" | false",
                "answers | a path | true",
                "answers | a name | true",
                "answers | another | false",
            })
    void aCaseIsWhereItsTestIsFed(String test, String name, boolean there) {
        assertEquals(there, JAVA.hasCase(test, name) || KOTLIN.hasCase(test, name));
    }
}
