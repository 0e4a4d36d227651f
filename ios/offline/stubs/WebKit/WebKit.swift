// STUB: what the app uses of Apple's WebKit, as we read its documentation. It checks names and types, and does nothing.
@_exported import UIKit

@MainActor open class WKNavigation: NSObject {}

@MainActor public protocol WKNavigationDelegate: NSObjectProtocol {
  func webView(_ webView: WKWebView, didFinish navigation: WKNavigation!)
}

@MainActor open class WKWebView: UIView {
  open weak var navigationDelegate: (any WKNavigationDelegate)?
  @discardableResult
  open func loadFileURL(_ url: URL, allowingReadAccessTo readAccessURL: URL) -> WKNavigation? { fatalError() }
}
