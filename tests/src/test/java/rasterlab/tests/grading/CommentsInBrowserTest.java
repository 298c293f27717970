package rasterlab.tests.grading;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.deque.html.axecore.selenium.AxeBuilder;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.Keys;

/** A student asks about a line and staff answer there, by keys alone, wide and on a phone. */
@Tag("slow")
class CommentsInBrowserTest {
    @TempDir private Path folder;
    @TempDir private Path profile;

    @ParameterizedTest(name = "{0}, {1} pixels wide")
    @CsvSource({"en, 1280", "ru, 390"})
    void aQuestionIsAnsweredBesideItsLine(String language, int width) throws Exception {
        try (var server = ServerProcess.start(folder.resolve("course"));
                var browser = Browser.open(profile, language)) {
            browser.driver().manage().window().setSize(new Dimension(width, 1000));
            var instructor = GraderClient.of(server.address(), server.token());
            var course = instructor.post("/courses", "{\"name\":\"Graphics\"}");
            String joining = "{\"course\":\"%s\",\"name\":\"Ada\"}";
            String token =
                    instructor
                            .post("/join", joining.formatted(course.path("code").asText()))
                            .path("token")
                            .asText();
            String id = instructor.as(token).submit("line-bresenham", "class A {\n\n}\n");
            signIn(browser, server, token);
            browser.driver().get(server.address().resolve("/submissions/" + id).toString());
            browser.element("#handed > summary").sendKeys(Keys.ENTER);
            browser.element("#handed input[name=line]").sendKeys("2");
            browser.element("#handed textarea").sendKeys("Why <b>here</b>?");
            browser.element("#handed > form button").sendKeys(Keys.ENTER);
            assertEquals("Why <b>here</b>?", browser.text(".source li:nth-child(2) .words"));
            assertReadable(browser);

            signIn(browser, server, server.token());
            String questions = "/instructor/courses/" + course.path("course").asText();
            browser.driver().get(server.address().resolve(questions + "/questions").toString());
            browser.element("article a").sendKeys(Keys.ENTER);
            browser.element(".thread > details > summary").sendKeys(Keys.ENTER);
            browser.element(".thread > details textarea").sendKeys("So.");
            browser.element(".thread > details button").sendKeys(Keys.ENTER);
            assertEquals("So.", browser.text(".thread .said + .said .words"));
            assertReadable(browser);
            browser.screenshot("comments-" + language);
        }
    }

    private static void signIn(Browser browser, ServerProcess server, String token) {
        browser.driver().get(server.address().toString());
        browser.driver().manage().deleteAllCookies();
        browser.driver().get(server.address().toString());
        browser.fill("token", token);
        browser.element("form[action='/sign-in'] button").click();
        browser.element("form[action='/sign-out']");
    }

    /** The part of the comments is no wider than the window, and axe-core finds nothing in it. */
    private static void assertReadable(Browser browser) {
        var fits =
                "return document.documentElement.scrollWidth"
                        + " <= document.documentElement.clientWidth";
        assertTrue((Boolean) browser.driver().executeScript(fits), "scrolls sideways");
        var found = new AxeBuilder().include("#handed").analyze(browser.driver()).getViolations();
        assertEquals(List.of(), found.stream().map(one -> one.getHelp()).toList());
    }
}
