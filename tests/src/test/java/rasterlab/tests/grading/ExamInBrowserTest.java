package rasterlab.tests.grading;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.sql.SQLException;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.openqa.selenium.By;
import org.openqa.selenium.WebDriverException;

/** The page of an exam keeps the time and what is typed, as a browser runs its script. */
@Tag("slow")
class ExamInBrowserTest {
    private static final String EXAM =
            "{\"name\":\"Midterm\",\"exercises\":[\"line-bresenham\",\"predict-line\"],"
                    + "\"opens\":\"2026-01-01T00:00\",\"closes\":\"2098-01-01T00:00\","
                    + "\"minutes\":60,\"grace\":0}";
    private static final String TEXT = "textarea[name=source]";
    private static final String SHEET = "form[action$='/predict-line']";
    private static final String ANSWER = SHEET + " input[name^='answer-']";
    private static final String STATE = "form[data-draft] [role=status]";

    @TempDir private Path folder;
    @TempDir private Path profile;

    private ServerProcess server;
    private Browser browser;

    @BeforeEach
    void openExam() throws Exception {
        browser = Browser.open(profile, "en");
        server = ServerProcess.start(folder.resolve("course"));
        var instructor = GraderClient.of(server.address(), server.token());
        var course = instructor.post("/courses", "{\"name\":\"Graphics\"}");
        String joining = "{\"course\":\"" + course.path("code").asText() + "\",\"name\":\"Ada\"}";
        String student = instructor.post("/join", joining).path("token").asText();
        String exams = "/courses/" + course.path("course").asText() + "/exams";
        String exam = instructor.post(exams, EXAM).path("exam").asText();
        browser.driver().get(server.address().toString());
        browser.fill("token", student);
        browser.element("form[action='/sign-in'] button").click();
        browser.element("form[action='/sign-out']");
        browser.driver().get(server.address().resolve("/exams").toString());
        browser.element("form[action='/exams/" + exam + "/open'] button").click();
        browser.element("#clock");
    }

    @AfterEach
    void close() throws Exception {
        if (browser != null) browser.close();
        if (server != null) server.close();
    }

    @Test
    @DisplayName("the clock stands still, or tells more than is left")
    void theClockCountsDown() {
        int first = browser.waiting().until(driver -> left());
        assertTrue(first > 3_000 && first <= 3_600, first + " seconds are left");
        browser.waiting().until(driver -> left() < first);
    }

    @Test
    @DisplayName("what is typed is not kept by itself, or the page says so although it is not")
    void whatIsTypedIsKept() {
        type("class Mine { }");
        String saved = browser.element("form[data-draft]").getAttribute("data-saved");
        browser.waiting().until(driver -> browser.text(STATE).equals(saved));
        // What the window itself keeps must not stand in for the server.
        browser.driver().executeScript("sessionStorage.clear()");
        browser.driver().navigate().refresh();
        assertEquals("class Mine { }", browser.element(TEXT).getAttribute("value"));
    }

    @Test
    @DisplayName(
            "what was typed while the network was away is lost by a reload, or never reaches the server")
    void whatIsTypedOutlivesAReloadWithoutNetwork() {
        String page = browser.driver().getCurrentUrl();
        network(false);
        type("class Offline { }");
        String failed = browser.element("form[data-draft]").getAttribute("data-failed");
        browser.waiting().until(driver -> browser.text(STATE).equals(failed));
        try {
            browser.driver().navigate().refresh();
        } catch (WebDriverException expected) {
            // The driver says that there is no network.
        }
        network(true);
        // A reload would let the browser fill the field in again by itself.
        browser.driver().get("about:blank");
        browser.driver().get(page);
        assertEquals("class Offline { }", browser.element(TEXT).getAttribute("value"));
        String saved = browser.element("form[data-draft]").getAttribute("data-saved");
        browser.waiting().until(driver -> browser.text(STATE).equals(saved));
        assertEquals(
                0L, browser.driver().executeScript("return sessionStorage.length"), "still kept");
    }

    @Test
    @DisplayName("an answer in a field is not kept by itself, or lost by a reload before it is")
    void answersInFieldsAreKept() {
        browser.element(ANSWER).sendKeys("12");
        String saved = browser.element(SHEET).getAttribute("data-saved");
        String state = SHEET + " [role=status]";
        browser.waiting().until(driver -> browser.text(state).equals(saved));
        browser.driver().executeScript("sessionStorage.clear()");
        browser.driver().navigate().refresh();
        assertEquals("12", browser.element(ANSWER).getAttribute("value"));
        String page = browser.driver().getCurrentUrl();
        network(false);
        browser.element(ANSWER).sendKeys("x");
        network(true);
        browser.driver().get("about:blank");
        browser.driver().get(page);
        assertEquals("12x", browser.element(ANSWER).getAttribute("value"));
    }

    @Test
    @DisplayName("the form stays when time is over, or what was typed last is lost")
    void timeOverClosesTheForm() throws SQLException {
        type("class Last { }");
        endTime();
        passTime();
        browser.waiting().until(driver -> driver.getCurrentUrl().endsWith("/exams"));
        assertTrue(browser.driver().findElements(By.cssSelector(TEXT)).isEmpty());
        assertTrue(
                browser.driver().findElements(By.cssSelector("form[action$='/open']")).isEmpty());
    }

    @Test
    @DisplayName(
            "a page on which a sheet was refused stays when time is over, at an address that shows nothing")
    void timeOverLeavesARefusedSheet() throws SQLException {
        browser.element(ANSWER).sendKeys("no number");
        browser.element(SHEET + " button").click();
        browser.element(SHEET + " [aria-invalid]");
        assertTrue(browser.driver().getCurrentUrl().endsWith("/predict-line"));
        endTime();
        passTime();
        browser.waiting().until(driver -> driver.getCurrentUrl().endsWith("/exams"));
        browser.element("main h1");
    }

    @Test
    @DisplayName(
            "a text that a window keeps alone, not as the fields of a form, stops the clock or is lost")
    void aTextKeptAloneIsTaken() {
        String page = browser.driver().getCurrentUrl();
        browser.driver()
                .executeScript(
                        "for (const form of document.querySelectorAll('form[data-draft]'))"
                                + " sessionStorage.setItem(form.dataset.kept, 'class Kept { }')");
        browser.driver().get("about:blank");
        browser.driver().get(page);
        browser.waiting().until(driver -> left() != null);
        assertEquals("class Kept { }", browser.element(TEXT).getAttribute("value"));
        String saved = browser.element("form[data-draft]").getAttribute("data-saved");
        browser.waiting().until(driver -> browser.text(STATE).equals(saved));
    }

    /** Moves the page's own clock to the end. */
    private void passTime() {
        browser.driver()
                .executeScript(
                        "const now = performance.now.bind(performance);"
                                + "performance.now = () => now() + 3600 * 1000");
    }

    /** Lets the sitting have begun an hour and more ago. */
    private void endTime() throws SQLException {
        try (var database = CourseDatabase.of(folder.resolve("course"));
                var statement = database.connection().createStatement()) {
            statement.execute("PRAGMA busy_timeout = 20000");
            statement.execute("UPDATE exam_sittings SET started_at = '2026-01-01T00:00:00.000Z'");
        }
    }

    private void type(String text) {
        browser.paste(text);
    }

    /** The seconds that the clock shows, which a script has to have set. */
    private Integer left() {
        String[] parts = browser.text("#clock .left").split(":");
        if (parts.length != 3) return null;
        return Integer.parseInt(parts[0]) * 3600
                + Integer.parseInt(parts[1]) * 60
                + Integer.parseInt(parts[2]);
    }

    private void network(boolean there) {
        browser.driver().executeCdpCommand("Network.enable", Map.of());
        browser.driver()
                .executeCdpCommand(
                        "Network.emulateNetworkConditions",
                        Map.of(
                                "offline", !there,
                                "latency", 0,
                                "downloadThroughput", -1,
                                "uploadThroughput", -1));
    }
}
