package rasterlab.tests.grading;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.openqa.selenium.By;
import org.openqa.selenium.Keys;
import org.openqa.selenium.interactions.Actions;

/** The field of a source is an editor, and what is typed there outlives the page. */
@Tag("slow")
class EditorInBrowserTest {
    private static final String EXERCISE = "/exercises/line-bresenham";
    private static final String FIELD = "textarea[name=source]";
    private static final String BACK = "form[data-typed] > [role=status]";

    @TempDir private Path folder;
    @TempDir private Path profile;

    private ServerProcess server;
    private Browser browser;
    private GraderClient instructor;
    private String code;

    @BeforeEach
    void open() throws Exception {
        browser = Browser.open(profile, "en");
        server = ServerProcess.start(folder.resolve("course"));
        instructor = GraderClient.of(server.address(), server.token());
        code = instructor.post("/courses", "{\"name\":\"Graphics\"}").path("code").asText();
        signIn("Ada");
        read(EXERCISE);
    }

    @AfterEach
    void close() throws Exception {
        if (browser != null) browser.close();
        if (server != null) server.close();
    }

    @Test
    @DisplayName(
            "lines have no numbers, words no colors, or who moves by Tab cannot leave the editor")
    void theFieldIsAnEditor() throws Exception {
        type("class Mine {");
        keys(Keys.ENTER);
        keys("int x = 1; // one");
        browser.screenshot("student-editor");
        assertEquals("2", browser.text(".CodeMirror-code > div:last-child .CodeMirror-linenumber"));
        assertEquals("class", browser.text(".cm-keyword"));
        assertEquals("// one", browser.text(".cm-comment"));
        assertEquals("class Mine {\n    int x = 1; // one", value());
        keys(Keys.TAB);
        assertEquals("class Mine {\n    int x = 1; // one", value());
        assertTrue(browser.driver().findElements(By.cssSelector(".CodeMirror-focused")).isEmpty());
    }

    @Test
    @DisplayName(
            "what was typed is lost with the page, comes back after it was thrown away, or for somebody else")
    void whatIsTypedOutlivesThePage() throws Exception {
        type("class Mine { }");
        read(EXERCISE);
        String told = browser.element("form[data-typed]").getAttribute("data-back");
        assertTrue(browser.text(BACK).startsWith(told), browser.text(BACK));
        browser.screenshot("student-editor-back");
        assertEquals("class Mine { }", value());
        signIn("Bob");
        read(EXERCISE);
        assertEquals("", value());
        signIn("Cyd");
        read(EXERCISE);
        type("class Cyd { }");
        read(EXERCISE);
        browser.element(BACK + " button").click();
        assertEquals("", value());
        read(EXERCISE);
        assertFalse(isBack());
        assertEquals("", value());
    }

    @Test
    @DisplayName("what was submitted comes back as if it had not been")
    void whatWasSubmittedDoesNotComeBack() {
        type("class Mine { }");
        browser.element("form[data-typed] button").click();
        browser.element("#live");
        read(EXERCISE);
        assertFalse(isBack());
        assertEquals("", value());
    }

    @Test
    @DisplayName(
            "what was typed stays in the browser of a classroom after its student has signed out")
    void whatIsTypedGoesWithWhoSignsOut() {
        type("class Mine { }");
        assertEquals(1L, kept());
        browser.element("form[action='/sign-out'] button").click();
        browser.element("form[action='/sign-in']");
        assertEquals(0L, kept());
    }

    @Test
    @DisplayName("nothing is kept any more after something unreadable was")
    void anUnreadableDraftIsReplaced() {
        String name = browser.element("form[data-typed]").getAttribute("data-typed");
        browser.driver().executeScript("localStorage.setItem(arguments[0], '{bad')", name);
        read(EXERCISE);
        type("class Mine { }");
        read(EXERCISE);
        assertTrue(isBack());
        assertEquals("class Mine { }", value());
    }

    @Test
    @DisplayName("a link with a token signs nobody in, or its token stays in the address")
    void aLinkFillsTheTokenIn() throws Exception {
        String token = instructor.post("/join", joining("Dan")).path("token").asText();
        browser.driver().manage().deleteAllCookies();
        browser.driver().get(server.address() + "/#token=" + token);
        browser.waiting().until(driver -> !driver.getCurrentUrl().contains(token));
        new Actions(browser.driver()).sendKeys(Keys.ENTER).perform();
        browser.element("form[action='/sign-out']");
        assertEquals("Dan", browser.text(".who"));
    }

    private Object kept() {
        return browser.driver().executeScript("return localStorage.length");
    }

    private String joining(String name) {
        return "{\"course\":\"" + code + "\",\"name\":\"" + name + "\"}";
    }

    private boolean isBack() {
        return !browser.driver().findElements(By.cssSelector(BACK)).isEmpty();
    }

    private void read(String page) {
        browser.driver().get(server.address().resolve(page).toString());
        browser.element(".CodeMirror");
    }

    private void signIn(String name) throws Exception {
        String token = instructor.post("/join", joining(name)).path("token").asText();
        browser.driver().manage().deleteAllCookies();
        browser.driver().get(server.address().toString());
        browser.fill("token", token);
        browser.element("form[action='/sign-in'] button").click();
        browser.element("form[action='/sign-out']");
    }

    private void type(String text) {
        browser.element(".CodeMirror-code").click();
        keys(text);
    }

    private void keys(CharSequence text) {
        new Actions(browser.driver()).sendKeys(text).perform();
    }

    private String value() {
        return browser.element(FIELD).getDomProperty("value");
    }
}
