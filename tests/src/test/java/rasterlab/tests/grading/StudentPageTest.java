package rasterlab.tests.grading;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.tests.grading.Solutions.source;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.Locale;
import java.util.logging.Level;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.openqa.selenium.By;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.interactions.Actions;
import rasterlab.exercises.catalogue.Catalogue;

@Tag("slow")
class StudentPageTest {
    @TempDir private static Path folder;
    private static ServerProcess server;
    private static String code;

    @TempDir private Path profile;

    @BeforeAll
    static void startServer() throws Exception {
        server = ServerProcess.start(folder.resolve("course"));
        var instructor = GraderClient.of(server.address(), server.token());
        code = instructor.post("/courses", "{\"name\":\"Graphics\"}").path("code").asText();
    }

    @AfterAll
    static void stopServer() throws IOException {
        server.close();
    }

    @Test
    void theResultArrivesByItselfWithItsPictures() throws Exception {
        try (var browser = Browser.open(profile, "en")) {
            join(browser);
            handIn(browser, source(Solutions.WRONG));
            var verdict = browser.text("#live .verdict .status.wrong");
            assertEquals("wrong", verdict.toLowerCase(Locale.ROOT).replaceAll("[^a-z]", ""));
            browser.waiting().until(driver -> allPicturesAreThere(browser));
            browser.screenshot("student-result-wrong");
            assertNothingWentWrong(browser);
        }
    }

    @Test
    void aRefusalShowsItsLineAsTextNotAsMarkup() throws Exception {
        try (var browser = Browser.open(profile, "en")) {
            join(browser);
            var hostile = "\"<img src=x onerror=document.title='broken'>\"";
            handIn(browser, source(Solutions.FORBIDDEN).replace("0);", hostile + ".length());"));
            var diagnostics = browser.text("#live .diagnostics");
            assertTrue(diagnostics.contains("System.exit"), diagnostics);
            assertTrue(diagnostics.contains(hostile), diagnostics);
            assertFalse(browser.driver().getTitle().contains("broken"));
            assertNothingWentWrong(browser);
        }
    }

    @Test
    void aRussianBrowserIsAnsweredInRussian() throws Exception {
        try (var browser = Browser.open(profile, "ru")) {
            browser.driver().get(server.address().toString());
            assertEquals("ru", browser.element("html").getAttribute("lang"));
            join(browser);
            browser.driver().get(exercise().toString());
            browser.screenshot("student-exercise-russian");
            assertTrue(browser.text(".statement").matches("(?s).*\\p{IsCyrillic}{4}.*"));
            assertFitsIntoItsWidth(browser);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"point-in-triangle", "clip-segment", "shade-face"})
    void aWrongAnswerToAnyTopicIsShownInPictures(String id) throws Exception {
        try (var browser = Browser.open(profile, "ru")) {
            join(browser);
            browser.driver().get(server.address().resolve("/exercises/" + id).toString());
            assertTrue(browser.text(".statement").matches("(?s).*\\p{IsCyrillic}{4}.*"));
            assertFitsIntoItsWidth(browser);
            browser.screenshot("student-exercise-" + id);
            browser.paste(Catalogue.builtIn().named(id).starter());
            browser.element("form[action='/exercises/" + id + "'] button").click();
            browser.waiting().until(driver -> allPicturesAreThere(browser));
            assertFitsIntoItsWidth(browser);
            new Actions(browser.driver())
                    .scrollToElement(browser.element("#live .pictures:last-of-type img"))
                    .perform();
            browser.screenshot("student-result-" + id);
            assertNothingWentWrong(browser);
        }
    }

    @Test
    void hintsAreShownByAButtonThatSaysTheirCost() throws Exception {
        try (var browser = Browser.open(profile, "ru")) {
            join(browser);
            browser.driver().get(server.address().resolve("/exercises/color").toString());
            assertTrue(browser.text("#hints").contains("снимется: 1;"), browser.text("#hints"));
            for (int step = 1; step <= 3; step++) {
                browser.element("#hints button").click();
                String shown = "Подсказка %d из 3".formatted(step);
                browser.waiting()
                        .until(driver -> browser.text("#hints h3:last-of-type").equals(shown));
                assertFitsIntoItsWidth(browser);
            }
            new Actions(browser.driver())
                    .scrollToElement(browser.element("#hints .cost:last-child"))
                    .perform();
            browser.screenshot("student-hints");
            assertEquals("Все подсказки показаны.", browser.text("#hints > p:last-child"));
            browser.driver().manage().window().setSize(new Dimension(390, 900));
            browser.driver().get(server.address().resolve("/exercises/hermite").toString());
            browser.element("#hints button").click();
            browser.waiting().until(driver -> browser.text("#hints h3").equals("Подсказка 1 из 3"));
            new Actions(browser.driver())
                    .scrollToElement(browser.element("#hints button"))
                    .perform();
            browser.screenshot("student-hints-narrow");
            assertFitsIntoItsWidth(browser);
            assertNothingWentWrong(browser);
        }
    }

    @Test
    void inputsThatBreakMethodsArePaidOnTheirPage() throws Exception {
        try (var browser = Browser.open(profile, "ru")) {
            join(browser);
            browser.driver().get(server.address().resolve("/exercises").toString());
            browser.screenshot("student-exercises");
            assertEquals("ещё не начато", state(browser, "break-clip-segment"));
            String page = "/exercises/break-clip-segment";
            browser.driver().get(server.address().resolve(page).toString());
            assertFitsIntoItsWidth(browser);
            browser.screenshot("student-exercise-break");
            browser.paste("{\"window\": [0, 0, 10, 10], \"segments\": [[-5, 5, 5, 5]]}");
            browser.element("form[action='" + page + "'] button").click();
            browser.waiting()
                    .until(
                            driver ->
                                    browser.text("#live")
                                            .contains("левая сторона окна не отсекает"));
            assertFitsIntoItsWidth(browser);
            browser.screenshot("student-result-break");
            browser.waiting().until(driver -> browser.text("#live").contains("Баллы"));
            browser.driver().get(server.address().resolve("/exercises").toString());
            String state = state(browser, "break-clip-segment");
            assertTrue(state.matches("лучший результат: \\d+ из 100"), state);
            assertEquals("ещё не начато", state(browser, "break-clip-polygon"));
            assertFitsIntoItsWidth(browser);
            browser.screenshot("student-exercises-begun");
            assertNothingWentWrong(browser);
        }
    }

    private static String state(Browser browser, String exercise) {
        return browser.text("a[href='/exercises/" + exercise + "'] .state");
    }

    private static void join(Browser browser) {
        browser.driver().get(server.address().toString());
        browser.fill("course", code);
        browser.fill("name", "Ada <b>Lovelace</b>");
        browser.element("form[action='/join'] button").click();
        browser.element("code.token");
    }

    private static void handIn(Browser browser, String source) {
        browser.driver().get(exercise().toString());
        browser.paste(source);
        browser.element("form[action='/exercises/line-bresenham'] button").click();
    }

    private static URI exercise() {
        return server.address().resolve("/exercises/line-bresenham");
    }

    private static boolean allPicturesAreThere(Browser browser) {
        var pictures = browser.driver().findElements(By.cssSelector("#live .pictures img"));
        return pictures.size() >= 3
                && pictures.stream()
                        .allMatch(each -> !"0".equals(each.getDomProperty("naturalWidth")));
    }

    /** A blocked script, style or picture is reported to the console. */
    private static void assertNothingWentWrong(Browser browser) {
        var severe =
                browser.driver().manage().logs().get("browser").getAll().stream()
                        .filter(entry -> entry.getLevel().intValue() >= Level.SEVERE.intValue())
                        .toList();
        assertTrue(severe.isEmpty(), severe.toString());
    }

    private static void assertFitsIntoItsWidth(Browser browser) {
        var overflow =
                browser.driver()
                        .executeScript(
                                "return document.documentElement.scrollWidth - document.documentElement.clientWidth");
        assertEquals(0L, overflow, "pixels that the page is wider than the window");
    }
}
