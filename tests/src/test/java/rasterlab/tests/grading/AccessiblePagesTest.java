package rasterlab.tests.grading;

import static java.util.stream.Collectors.joining;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.deque.html.axecore.selenium.AxeBuilder;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.Keys;

/**
 * The pages have no serious finding of axe-core: contrast, names for readers that speak, order of
 * headings, labels of fields. Each is looked at wide and narrow, light and dark.
 */
@Tag("slow")
class AccessiblePagesTest {
    private static final Set<String> SERIOUS = Set.of("serious", "critical");

    private static final String EXAM =
            "{\"name\":\"Midterm\",\"exercises\":[\"line-bresenham\",\"predict-circle\"],"
                    + "\"opens\":\"2026-01-01T00:00\",\"closes\":\"2098-01-01T00:00\","
                    + "\"minutes\":4,\"grace\":30}";

    @TempDir private static Path folder;
    private static ServerProcess server;
    private static GraderClient instructor;
    private static String code;

    @TempDir private Path profile;

    @BeforeAll
    static void startServer() throws Exception {
        server = ServerProcess.start(folder.resolve("course"));
        instructor = GraderClient.of(server.address(), server.token());
        code = instructor.post("/courses", "{\"name\":\"Graphics\"}").path("code").asText();
    }

    @AfterAll
    static void stopServer() throws IOException {
        server.close();
    }

    @ParameterizedTest(name = "{0}, {1}, {2} pixels wide")
    @CsvSource({"en, light, 1280", "ru, dark, 1280", "ru, light, 390", "en, dark, 390"})
    void studentPagesHaveNoSeriousFinding(String language, String scheme, int width)
            throws Exception {
        try (Browser browser = Browser.open(profile, language)) {
            dress(browser, scheme, width);
            List<String> findings = new ArrayList<>(findings(browser, "/"));
            browser.fill("course", code);
            browser.fill("name", "Ada");
            browser.element("form[action='/join'] button").click();
            browser.element("code.token");
            findings.addAll(findings(browser, "the new token"));
            for (String page :
                    List.of(
                            "/exercises",
                            "/exercises/line-bresenham",
                            "/exercises/break-clip-segment",
                            "/exercises/predict-circle",
                            "/exams")) findings.addAll(findings(browser, page));
            browser.driver().get(address("/exercises/line-bresenham"));
            browser.paste(Solutions.source(Solutions.WRONG));
            browser.element("form[action='/exercises/line-bresenham'] button").click();
            browser.text("#live .verdict .status.wrong");
            findings.addAll(findings(browser, "a result"));
            browser.element(".complain summary").click();
            browser.element(".complain[open] textarea").sendKeys("It is drawn.");
            browser.element(".complain[open] form button").click();
            browser.text(".case .thread .waits");
            findings.addAll(findings(browser, "a complaint"));
            browser.driver().get(address("/exercises/line-bresenham"));
            browser.paste(Solutions.source(Solutions.RIGHT));
            browser.element("form[action='/exercises/line-bresenham'] button").click();
            browser.text("#live .verdict .status.ok");
            browser.element("a[href$='/compare']").click();
            browser.element(".versions");
            findings.addAll(findings(browser, "two versions"));
            findings.addAll(findings(browser, "/exercises/line-bresenham/front"));
            assertEquals(List.of(), findings);
        }
    }

    @ParameterizedTest(name = "{0}, {1}, {2} pixels wide")
    @CsvSource({"en, light, 1280", "ru, dark, 390"})
    void instructorPagesHaveNoSeriousFinding(String language, String scheme, int width)
            throws Exception {
        String joining = "{\"course\":\"" + code + "\",\"name\":\"Emmy\"}";
        var student = instructor.as(instructor.post("/join", joining).path("token").asText());
        String broken = "class A {\n" + " ".repeat(8) + "int " + "a".repeat(200) + " = b;\n}\n";
        String submission = student.submit("line-bresenham", broken);
        student.result(submission);
        try (Browser browser = Browser.open(profile, language)) {
            dress(browser, scheme, width);
            signIn(browser, server.token());
            List<String> findings = new ArrayList<>();
            for (String page : pagesOf(browser)) findings.addAll(findings(browser, page));
            findings.addAll(findings(browser, "/submissions/" + submission));
            assertScrolledByKeys(browser, ".diagnostics pre");
            findings.addAll(findings(browser, "/instructor/submissions/" + submission + "/trials"));
            browser.element("form[action$='/trials'] button").click();
            browser.text("#live .diagnostics");
            findings.addAll(findings(browser, "a copy"));
            browser.driver().get(address("/submissions/" + submission));
            browser.element("form[action$='/view'] button").click();
            browser.element(".viewing");
            findings.addAll(findings(browser, "a student's view"));
            assertEquals(List.of(), findings);
        }
    }

    @ParameterizedTest(name = "{0}, {1}, {2} pixels wide")
    @CsvSource({"en, dark, 1280", "ru, light, 390"})
    void examPagesHaveNoSeriousFinding(String language, String scheme, int width) throws Exception {
        String course = instructor.post("/courses", "{\"name\":\"Exam\"}").path("code").asText();
        String joining = "{\"course\":\"" + course + "\",\"name\":\"Emmy\"}";
        String student = instructor.post("/join", joining).path("token").asText();
        String exam = instructor.post("/courses/" + course + "/exams", EXAM).path("exam").asText();
        try (Browser browser = Browser.open(profile, language)) {
            dress(browser, scheme, width);
            signIn(browser, student);
            List<String> findings = new ArrayList<>(findings(browser, "/exams"));
            browser.element("form[action='/exams/" + exam + "/open'] button").click();
            browser.element("#clock");
            findings.addAll(findings(browser, "an exam"));
            browser.element("form[action='/sign-out'] button").click();
            signIn(browser, server.token());
            findings.addAll(findings(browser, "/instructor/exams/" + exam));
            assertEquals(List.of(), findings);
        }
    }

    /** Moves a part that does not fit into its width by the keys of the arrows. */
    private static void assertScrolledByKeys(Browser browser, String css) {
        var part = browser.element(css);
        part.sendKeys(Keys.ARROW_RIGHT);
        browser.waiting()
                .until(
                        driver ->
                                (Boolean)
                                        browser.driver()
                                                .executeScript(
                                                        "return arguments[0].scrollLeft > 0",
                                                        part));
    }

    private static void signIn(Browser browser, String token) {
        browser.driver().get(address("/"));
        browser.fill("token", token);
        browser.element("form[action='/sign-in'] button").click();
        browser.element("form[action='/sign-out']");
    }

    /** The pages that the instructor's own page leads to, and that one, one of each kind. */
    private static List<String> pagesOf(Browser browser) {
        browser.driver().get(address("/instructor"));
        List<String> pages = new ArrayList<>(List.of("/instructor"));
        @SuppressWarnings("unchecked")
        List<String> links =
                (List<String>)
                        browser.driver()
                                .executeScript(
                                        "return [...document.querySelectorAll('main a[href]')]"
                                                + ".map(a => a.getAttribute('href'))");
        for (String link : links)
            if (link.startsWith("/instructor") && !link.contains(".") && !pages.contains(link))
                pages.add(link);
        return pages;
    }

    private static void dress(Browser browser, String scheme, int width) {
        browser.driver().manage().window().setSize(new Dimension(width, 1000));
        browser.driver()
                .executeCdpCommand(
                        "Emulation.setEmulatedMedia",
                        Map.of(
                                "features",
                                List.of(Map.of("name", "prefers-color-scheme", "value", scheme))));
    }

    private static String address(String path) {
        return server.address().resolve(path).toString();
    }

    /** Returns what axe-core finds on that page, or on the one that is open where it is no path. */
    private static List<String> findings(Browser browser, String page) {
        if (page.startsWith("/")) browser.driver().get(address(page));
        return new AxeBuilder()
                .analyze(browser.driver()).getViolations().stream()
                        .filter(one -> SERIOUS.contains(one.getImpact()))
                        .map(
                                one ->
                                        page
                                                + ": "
                                                + one.getHelp()
                                                + ": "
                                                + one.getNodes().stream()
                                                        .map(node -> node.getHtml())
                                                        .limit(3)
                                                        .collect(joining(" ")))
                        .toList();
    }
}
