import UIKit
import WebKit

/// Prints a report, or saves it as PDF: iOS asks which. The page, pictures and all, is laid out by a web view, which must live
/// until then.
@MainActor final class ReportPrinter: NSObject, WKNavigationDelegate {
  private let page = WKWebView()

  func print(_ report: URL) {
    page.navigationDelegate = self
    page.loadFileURL(report, allowingReadAccessTo: report)
  }

  func webView(_ webView: WKWebView, didFinish navigation: WKNavigation!) {
    let info = UIPrintInfo(dictionary: nil)
    (info.jobName, info.outputType) = (Words.report, .general)
    let printer = UIPrintInteractionController.shared
    printer.printInfo = info
    printer.printFormatter = webView.viewPrintFormatter()
    // An iPad shows the printers beside something; an iPhone takes the whole screen.
    if UIDevice.current.userInterfaceIdiom == .pad, let window = Self.window {
      let top = CGRect(x: window.bounds.midX, y: 0, width: 1, height: 1)
      printer.present(from: top, in: window, animated: true, completionHandler: nil)
    } else {
      printer.present(animated: true, completionHandler: nil)
    }
  }

  private static var window: UIWindow? {
    UIApplication.shared.connectedScenes.compactMap { ($0 as? UIWindowScene)?.keyWindow }.first
  }
}
