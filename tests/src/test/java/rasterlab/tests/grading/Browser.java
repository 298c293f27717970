package rasterlab.tests.grading;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.openqa.selenium.By;
import org.openqa.selenium.OutputType;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.chrome.ChromeDriver;
import org.openqa.selenium.chrome.ChromeDriverService;
import org.openqa.selenium.chrome.ChromeOptions;
import org.openqa.selenium.support.ui.WebDriverWait;

/**
 * Headless Chromium with an empty profile.
 *
 * @param profile the profile's folder, which Chromium fills
 */
record Browser(ChromeDriver driver, Path profile) implements AutoCloseable {
    private static final Duration PATIENCE = Duration.ofMinutes(2);

    /** Skips the test, naming the part, where Chromium or its driver is missing. */
    static Browser open(Path profile, String language) {
        var chromium = found("chromium", "chromium-browser", "google-chrome");
        var driver = found("chromedriver");
        assumeTrue(chromium != null, "no chromium on the PATH");
        assumeTrue(driver != null, "no chromedriver on the PATH");
        var options = new ChromeOptions();
        options.setBinary(chromium);
        options.addArguments(
                "--headless=new",
                "--no-sandbox",
                "--disable-gpu",
                "--disable-dev-shm-usage",
                "--disable-background-networking",
                "--disable-component-update",
                "--disable-sync",
                "--no-first-run",
                "--window-size=1280,1000",
                "--lang=" + language,
                "--accept-lang=" + language,
                "--user-data-dir=" + profile);
        var service =
                new ChromeDriverService.Builder().usingDriverExecutable(new File(driver)).build();
        return new Browser(new ChromeDriver(service, options), profile);
    }

    /** Fills the one field of that name. */
    void fill(String name, String text) {
        element("[name=" + name + "]").sendKeys(text);
    }

    /** Puts a source into the editor, at once as by a paste. */
    void paste(String source) {
        element(".CodeMirror");
        driver.executeScript(
                "document.querySelector('.CodeMirror').CodeMirror.setValue(arguments[0])", source);
    }

    WebElement element(String css) {
        return waiting().until(driver -> driver.findElement(By.cssSelector(css)));
    }

    /** The text of the element; one that the page replaces meanwhile is looked up again. */
    String text(String css) {
        return waiting().until(driver -> driver.findElement(By.cssSelector(css)).getText());
    }

    WebDriverWait waiting() {
        var wait = new WebDriverWait(driver, PATIENCE);
        wait.ignoring(org.openqa.selenium.NoSuchElementException.class);
        wait.ignoring(org.openqa.selenium.StaleElementReferenceException.class);
        return wait;
    }

    /** Saves what the page looks like for people, under the build folder. */
    void screenshot(String name) throws IOException {
        var file = Path.of("target", "screenshots", name + ".png");
        Files.createDirectories(file.getParent());
        Files.write(file, driver.getScreenshotAs(OutputType.BYTES));
    }

    private static String found(String... names) {
        var folders = System.getenv("PATH").split(File.pathSeparator);
        return Stream.of(names)
                .flatMap(name -> Stream.of(folders).map(folder -> new File(folder, name)))
                .filter(File::canExecute)
                .map(File::getPath)
                .findFirst()
                .orElse(null);
    }

    /** Returns when no process of it is left that could still write to the profile. */
    @Override
    public void close() {
        var processes = processes();
        driver.quit();
        for (var process : processes)
            process.onExit().orTimeout(PATIENCE.toSeconds(), TimeUnit.SECONDS).join();
    }

    private static List<ProcessHandle> processes() {
        return ProcessHandle.current()
                .descendants()
                .filter(each -> each.info().command().orElse("").contains("chrom"))
                .toList();
    }
}
