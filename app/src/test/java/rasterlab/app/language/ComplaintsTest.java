package rasterlab.app.language;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ComplaintsTest {
    /** Sentences that no file has; all patterns are tried. */
    private static final String UNKNOWN = "a sentence of the operating system";

    /** Bytes; compiling all patterns takes twice as many. */
    private static final long MOST = 400_000;

    @ParameterizedTest(
            name =
                    "a number is written as Java does, or a file''s number otherwise, or quotes are those of programs: {1}")
    @CsvSource(
            delimiter = '|',
            value = {
                "ENGLISH | $.far: must be a number from -1000000.0 to 1.0E30, got 1e309"
                        + " | $.far: must be a number from −1000000 to 10³⁰, got 1e309",
                "RUSSIAN | $.far: must be a number from -1000000.0 to 1.0E30, got 1e309"
                        + " | $.far: должно быть число от −1000000 до 10³⁰, получено 1e309",
                "RUSSIAN | zoom must be in [0.001, 1000.0], got -2.5E-7"
                        + " | увеличение должно быть в [0,001; 1000], получено −2,5·10⁻⁷",
                "RUSSIAN | corner 7: normal (0.0, -0.5, 2.0) must have length 1, got 2.5"
                        + " | вершина 7: нормаль (0; −0,5; 2) должна иметь длину 1, получено 2,5",
                "RUSSIAN | direction to the light must be finite and not zero, got (0.0, -0.5, NaN)"
                        + " | направление на источник должно быть конечным и не нулевым,"
                        + " получено (0; −0,5; NaN)",
                "RUSSIAN | numbers of a clip plane must be from -1.0E30 to 1.0E30, got 1.0E300"
                        + " | числа плоскости отсечения должны быть от −10³⁰ до 10³⁰,"
                        + " получено 10³⁰⁰",
                "RUSSIAN | no result within 5 s | результата нет за 5\u00a0с",
                "RUSSIAN | the server did not say its address; its last words: no folder a"
                        + " | сервер не сообщил свой адрес; его последние слова: no folder a",
                "RUSSIAN | face 3: corners 0, 1, 2 span no area"
                        + " | грань 3: вершины 0, 1, 2 не охватывают площади",
                "RUSSIAN | world to eye must have an inverse, got determinant 150.28236737529534"
                        + " | у перехода от мира к наблюдателю должна быть обратная матрица,"
                        + " а её определитель 150,282",
                "RUSSIAN | point 2 (9.0, 9.0) is outside but judged inside, 1.592e+15 ulps from the"
                        + " boundary | точка 2 (9; 9) снаружи, а признана внутренней;"
                        + " до границы 1,592·10¹⁵ ulp",
                "RUSSIAN | segment 0 is sent as (NaN, 0.5)→(-Infinity, 10.0), nothing is left"
                        + " | отрезок 0 выдан как (NaN; 0,5)→(−∞; 10), а от него ничего не остаётся",
                "RUSSIAN | /zmin: must be a number above 0 and below 1, got 2.0"
                        + " | /zmin: должно быть числом больше 0 и меньше 1, получено 2",
                "RUSSIAN | OpenGL 1.3 is older than 1.4 | версия OpenGL 1.3 раньше 1.4",
                "ENGLISH | no course with the code 'X'; ask for it"
                        + " | no course with the code “X”; ask for it",
                "ENGLISH | the teachers' z'/dz' of '' | the teachers' z'/dz' of “”",
                "RUSSIAN | face 'x' flies away | face «x» flies away",
                "RUSSIAN | unknown option '{'from':1}' | неизвестный параметр «{'from':1}»",
                "RUSSIAN | flatness must be at least 5.820766091346741E-11 where coordinates reach"
                        + " 4.123456789, got 1.0E-12 | flatness должно быть не меньше"
                        + " 5,820766091346741·10⁻¹¹, если координаты доходят до 4,12346,"
                        + " получено 10⁻¹²",
                "RUSSIAN | no folder -1.5.0 | нет папки -1.5.0",
                "RUSSIAN | /x/half.png: the picture is cut off: the file ends too early; allowed are"
                        + " whole pictures as PNG, JPEG, GIF or BMP; an image of the lab is shown"
                        + " instead | /x/half.png: изображение обрезано: файл кончается слишком рано;"
                        + " годятся неповреждённые изображения PNG, JPEG, GIF или BMP; вместо него показано"
                        + " изображение этой вкладки",
            })
    void numbersHaveTheFormOfTheLanguage(Language language, String english, String said) {
        assertEquals(said, Complaints.translated(language, english));
    }

    @ParameterizedTest(name = "a number has Java''s capital E or .0, or a name loses its own: {1}")
    @CsvSource(
            delimiter = '|',
            value = {
                "ENGLISH | up must lie at least 1.0E-8 radians off | up must lie at least 1e-8 radians off",
                "ENGLISH | y must be within ±1.0E100, got NaN | y must be within ±1e100, got NaN",
                "ENGLISH | must be from -1E75 to 1E75 | must be from -1e75 to 1e75",
                "ENGLISH | must be in 1.0E-75..1.0E75, got 2.5 | must be in 1e-75..1e75, got 2.5",
                "ENGLISH | turn must be in [0, 360), got (0.0, -1.0, 3.5E-11)"
                        + " | turn must be in [0, 360), got (0, -1, 3.5e-11)",
                "ENGLISH | zoom must be in [0.001, 1000.0], got 0.0"
                        + " | zoom must be in [0.001, 1000], got 0",
                "ENGLISH | no course with the code '1.0'; ask for it"
                        + " | no course with the code '1.0'; ask for it",
                "ENGLISH | /tmp/1.0E5: no file '-1.0E5' or x1.0E5.obj"
                        + " | /tmp/1.0E5: no file '-1.0E5' or x1.0E5.obj",
                "RUSSIAN | no such sentence: 1.0E-8 | no such sentence: 1e-8",
            })
    void powersOfTenAreTyped(Language language, String english, String said) {
        assertEquals(said, Complaints.saidToTypist(language, english));
    }

    @ParameterizedTest(name = "an older sentence about one case is taken for the general one: {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "hvs lies outside the colour cube: its red would be 1.1666666666666667,"
                        + " allowed is 0 to 1 | красный был бы 1,16667, а допустимо",
                "red of point 2 is 0.5, right is 0.25 | красный в точке 2: 0,5, верно 0,25",
                "the scene must be one convex closed body for method 'convex': face 3 has no neighbour"
                        + " at its edge from vertex 1 to 2 | методу «convex» нужно одно выпуклое"
                        + " замкнутое тело: у грани 3 нет соседа на ребре от вершины 1 до 2",
                "the scene must be one convex closed body for method 'convex': a corner of face 3 lies"
                        + " outside face 4, by 0.25 units | замкнутое тело: вершина грани 3 лежит"
                        + " снаружи грани 4, на расстоянии 0,25",
            })
    void oneSentenceIsTakenForAllItsCases(String english, String part) {
        String said = Complaints.translated(Language.RUSSIAN, english);
        assertTrue(said.contains(part), said);
    }

    @Test
    void patternsAreNotCompiledForEverySentence() {
        var threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        assertEquals(UNKNOWN, Complaints.translated(Language.RUSSIAN, UNKNOWN));
        long before = threads.getCurrentThreadAllocatedBytes();
        Complaints.translated(Language.RUSSIAN, UNKNOWN);
        long taken = threads.getCurrentThreadAllocatedBytes() - before;
        assertTrue(taken < MOST, taken + " bytes");
    }
}
